/*
 * The one function that Java 21 looks for in iphlpapi.dll and Wine 8 lacks; without it, Java ends when it is asked for
 * the network's interfaces, which its random numbers do. It knows no anycast addresses. .ci/packages-windows makes a
 * iphlpapi.dll of this, whose other functions are those of Wine's.
 */
#include <windows.h>

DWORD WINAPI GetAnycastIpAddressTable(USHORT family, void **table) {
  (void)family;
  *table = HeapAlloc(GetProcessHeap(), HEAP_ZERO_MEMORY, 64);
  return *table == NULL ? ERROR_NOT_ENOUGH_MEMORY : NO_ERROR;
}
