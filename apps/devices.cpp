// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>

#ifdef LINELET_HAS_OPENCL
#include <linelet/opencl/device.h>
#endif

#include "commands.h"
#include "frame.h"

namespace linelet::apps {

int
runDevices(const std::vector<std::string>& arguments)
{
  Frame frame("devices",
              "Lists the OpenCL devices that tensor --engine opencl and cluster "
              "--device can use.");
  frame.parse(arguments);
  frame.summary["devices"] = nlohmann::ordered_json::array();
#ifdef LINELET_HAS_OPENCL
  std::size_t number = 0;
  for (const opencl::Device& device : opencl::devices()) {
    std::printf(
        "%zu  %s (%s), %u compute units, %.1f GiB, double precision: %s\n   %s\n",
        number++,
        device.name.c_str(),
        device.type.c_str(),
        device.compute_units,
        static_cast<double>(device.memory) / (1 << 30),
        device.double_precision ? "yes" : "no",
        device.version.c_str());
    frame.summary["devices"].push_back({{"name", device.name},
                                        {"platform", device.platform},
                                        {"type", device.type},
                                        {"version", device.version},
                                        {"compute_units", device.compute_units},
                                        {"memory", device.memory},
                                        {"double_precision", device.double_precision}});
  }
  if (number == 0)
    std::printf("there is no OpenCL device; on Debian, apt-get install pocl-opencl-icd "
                "makes one of the processor\n");
#else
  std::printf("this linelet was built without OpenCL\n");
#endif
  return frame.finish();
}

} // namespace linelet::apps
