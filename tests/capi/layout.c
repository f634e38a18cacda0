/* SPDX-License-Identifier: Apache-2.0 */
/* Every struct of the C interface has the size and the offsets of layout_table.h, and the library reports the same.
 * Compiles as C99 and as C++98. */
#include <abut/picking.h>
#include <abut/response.h>

#include <stdio.h>
#include <string.h>

#include "layout_table.h"

/* An array of -1 elements does not compile: an assertion for languages that have none. */
#define ABUT_ASSERT_TYPE(type, size) typedef char abut_assert_##type[sizeof(type) == (size) ? 1 : -1];
#define ABUT_ASSERT_FIELD(type, field, offset, size) \
  typedef char abut_assert_##type##_##field          \
      [offsetof(type, field) == (offset) && sizeof(((const type*)0)->field) == (size) ? 1 : -1];
ABUT_LAYOUT(ABUT_ASSERT_TYPE, ABUT_ASSERT_FIELD)
ABUT_PICKING_LAYOUT(ABUT_ASSERT_TYPE, ABUT_ASSERT_FIELD)
ABUT_RESPONSE_LAYOUT(ABUT_ASSERT_TYPE, ABUT_ASSERT_FIELD)

/* The report has no duplicates and as many entries as the table, so finding each of the table is equality. */
static int abut_report_has(const char* type, const char* field, uint64_t offset, uint64_t size) {
  size_t found = 0;
  size_t i;
  for (i = 0; i < abut_layout_count(); ++i) {
    abut_layout_entry entry;
    if (abut_layout_at(i, &entry) != ABUT_OK) return 0;
    if (strcmp(entry.type, type) == 0 && strcmp(entry.field, field) == 0) {
      found += entry.offset == offset && entry.size == size ? 1 : 2;
    }
  }
  if (found != 1) printf("the report differs from the table at %s.%s\n", type, field);
  return found == 1;
}

#define ABUT_CHECK_TYPE(type, size)            \
  good &= abut_report_has(#type, "", 0, size); \
  ++count;
#define ABUT_CHECK_FIELD(type, field, offset, size)     \
  good &= abut_report_has(#type, #field, offset, size); \
  ++count;

int main(void) {
  int good = 1;
  size_t count = 0;
  ABUT_LAYOUT(ABUT_CHECK_TYPE, ABUT_CHECK_FIELD)
  if (abut_layout_count() != count) {
    printf("the report has %u entries, the table %u\n", (unsigned)abut_layout_count(), (unsigned)count);
    good = 0;
  }
  return good ? 0 : 1;
}
