/*
 * Adds a folder to the PATH of this user, or removes it:
 *
 *   user-path.exe add|remove FOLDER
 *
 * The installer and the uninstaller call it. Their own language cannot do it safely: it cuts texts at 1024 letters, and
 * a PATH is often longer. Other folders stay as they are, and so does the kind of the registry's value, in which
 * %NAMES% of variables may stand.
 */
#include <windows.h>
#include <stdlib.h>
#include <wchar.h>

/* The length of a folder without quotes around it and backslashes at its end; *start is set to its first letter. */
static size_t trimmed(const wchar_t *entry, size_t length, const wchar_t **start) {
  while (length > 0 && (*entry == L'"' || *entry == L' ')) {
    entry++;
    length--;
  }
  while (length > 0 && wcschr(L"\\\" ", entry[length - 1]) != NULL) {
    length--;
  }
  *start = entry;
  return length;
}

static int same_folder(const wchar_t *one, size_t one_length, const wchar_t *other) {
  const wchar_t *a, *b;
  size_t length = trimmed(one, one_length, &a);
  return length == trimmed(other, wcslen(other), &b) && _wcsnicmp(a, b, length) == 0;
}

/* Copies the entries of a PATH that are not the folder; returns how many were. */
static int remove_entries(const wchar_t *path, const wchar_t *folder, wchar_t *result) {
  int found = 0;
  wchar_t *end = result;
  for (;;) {
    size_t length = wcscspn(path, L";");
    if (same_folder(path, length, folder)) {
      found++;
    } else {
      wmemcpy(end, path, length);
      end += length;
      if (path[length] != 0) {
        *end++ = L';';
      }
    }
    if (path[length] == 0) {
      break;
    }
    path += length + 1;
  }
  /* The separator before a last entry that went. */
  if (found > 0 && end > result && end[-1] == L';') {
    end--;
  }
  *end = 0;
  return found;
}

int wmain(int count, wchar_t **arguments) {
  HKEY key;
  DWORD type = REG_EXPAND_SZ, size = 0;
  LSTATUS status;
  wchar_t *path, *changed;
  int add, found;

  if (count != 3 || (wcscmp(arguments[1], L"add") != 0 && wcscmp(arguments[1], L"remove") != 0)) {
    return 2;
  }
  add = wcscmp(arguments[1], L"add") == 0;
  if (RegCreateKeyExW(HKEY_CURRENT_USER, L"Environment", 0, NULL, 0, KEY_READ | KEY_WRITE, NULL, &key, NULL) != 0) {
    return 1;
  }
  status = RegQueryValueExW(key, L"Path", NULL, &type, NULL, &size);
  if (status != ERROR_FILE_NOT_FOUND && (status != 0 || (type != REG_SZ && type != REG_EXPAND_SZ))) {
    return 1; /* What cannot be read is not written over. */
  }
  path = calloc(size + 2, sizeof(wchar_t));
  changed = calloc(size + wcslen(arguments[2]) + 4, sizeof(wchar_t));
  if (path == NULL || changed == NULL ||
      (status == 0 && RegQueryValueExW(key, L"Path", NULL, &type, (BYTE *)path, &size) != 0)) {
    return 1;
  }
  found = remove_entries(path, arguments[2], changed);
  if (add ? found > 0 : found == 0) {
    return 0;
  }
  if (add) {
    if (*changed != 0 && changed[wcslen(changed) - 1] != L';') {
      wcscat(changed, L";");
    }
    wcscat(changed, arguments[2]);
  }
  status = *changed == 0 ? RegDeleteValueW(key, L"Path")
                         : RegSetValueExW(key, L"Path", 0, type, (const BYTE *)changed,
                                          (wcslen(changed) + 1) * sizeof(wchar_t));
  RegCloseKey(key);
  /* The desktop gives the new PATH to what it starts from now on. */
  SendMessageTimeoutW(HWND_BROADCAST, WM_SETTINGCHANGE, 0, (LPARAM)L"Environment", SMTO_ABORTIFHUNG, 2000, NULL);
  return status == 0 ? 0 : 1;
}
