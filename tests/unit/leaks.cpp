// What the leak sanitizer shall not report: OpenImageIO keeps a thread's last error message for
// good where a reader failed.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:OpenImageIO_v2_4::ImageInput::geterror\n";
}
