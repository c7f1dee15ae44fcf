// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "support/groups.h"

using namespace linelet;

namespace {

TEST(Groups, AreJoinedByTheirMembersAndNamedByTheFirst)
{
  Groups groups(6);
  EXPECT_TRUE(groups.unite(4, 5));
  EXPECT_TRUE(groups.unite(3, 1));
  EXPECT_TRUE(groups.unite(5, 3)); // 1 3 4 5
  EXPECT_FALSE(groups.unite(1, 4));
  for (const std::size_t i : {1, 3, 4, 5})
    EXPECT_EQ(groups.root(i), 1u);
  EXPECT_EQ(groups.root(0), 0u);
  EXPECT_EQ(groups.root(2), 2u);
}

} // namespace
