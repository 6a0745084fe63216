#include <stddef.h>
#include <stdint.h>

size_t host_bytes(uint32_t balls);

int main(void) {
  return host_bytes(3) > 1000 && host_bytes(6) > host_bytes(3) ? 0 : 1;
}
