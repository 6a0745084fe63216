#include "pdf_writer_cases.hpp"

#include "expect_cases.hpp"

TEST(PdfWriter, Cases) {
  expect_cases(cases::picture_pdf_writer);
}
