/*
 * Starts the program on Windows, on the Java that lies beside it.
 *
 * java.exe is not good enough: it reads its command line in the code page of the system, so that on an English
 * Windows a file called "σκηνή.x3d" arrives as "?????.x3d". This launcher makes the Java virtual machine (JVM) itself,
 * by JNI's invocation API, and hands the arguments over as Windows has them, in UTF-16.
 *
 * It is compiled four times (packaging/parts/windows):
 *
 *   selective-renderer.exe              the command line
 *   Selective Renderer.exe              -DDESKTOP=L"run": has no console; opens a file in the viewer, and without one
 *                                       the start window
 *   Selective Renderer Enricher.exe     -DDESKTOP=L"enrich": likewise, in the enricher
 *   runtime\bin\java.exe, javaw.exe     -DJAVA: in place of Java's own, with the arguments of these as far as the
 *                                       program uses them. It starts itself again for some work, and names files there.
 *
 * Which flags Java gets stands in app\launcher.cfg. The environment variables are those of the launcher for other
 * systems: SELECTIVE_RENDERER_JAVA_OPTS, SELECTIVE_RENDERER_SAI.
 */
#include <windows.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <wchar.h>

#include <jni.h>

#ifndef DESKTOP
#define DESKTOP NULL
#endif
#ifdef JAVA
static const int java = 1;
#else
static const int java = 0;
#endif
#define MAIN L"org.selectiverenderer.cli.Main"
/* The longest path that Windows knows. */
#define PATH 32768

/* The command line's launcher expands patterns of file names, as java.exe does: here no shell does it. */
int _dowildcard = EXPAND;

/* --- Memory and messages ------------------------------------------------------------------------------------------ */

static void write_error(const wchar_t *text) {
  char utf8[4 * 4096];
  DWORD written;
  int length = WideCharToMultiByte(CP_UTF8, 0, text, -1, utf8, sizeof utf8, NULL, NULL);
  if (length > 1) {
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), utf8, length - 1, &written, NULL);
  }
}

static void close_picture(void);

/* Says in one sentence why the program cannot start, in a window where nobody sees a terminal, and ends. */
static void fail(const wchar_t *format, ...) {
  wchar_t text[4096] = L"selective-renderer: ";
  size_t prefix = wcslen(text);
  va_list values;
  va_start(values, format);
  _vsnwprintf(text + prefix, 4096 - prefix - 2, format, values);
  va_end(values);
  if (DESKTOP != NULL) {
    close_picture(); /* It would lie above the window. */
    MessageBoxW(NULL, text + prefix, L"Selective Renderer", MB_OK | MB_ICONERROR | MB_SETFOREGROUND);
  }
  wcscat(text, L"\n");
  write_error(text);
  ExitProcess(2);
}

static void *checked(void *memory) {
  if (memory == NULL) {
    fail(L"there is no memory left to start; close other programs");
  }
  return memory;
}

/* A new string of a printf format. */
static wchar_t *text(const wchar_t *format, ...) {
  wchar_t *result;
  int length;
  va_list values;
  va_start(values, format);
  length = _vscwprintf(format, values);
  va_end(values);
  result = checked(calloc(length + 1, sizeof(wchar_t)));
  va_start(values, format);
  _vsnwprintf(result, length, format, values);
  va_end(values);
  return result;
}

/* The value of an environment variable, or NULL where it is not set or empty. */
static wchar_t *environment(const wchar_t *name) {
  DWORD size = GetEnvironmentVariableW(name, NULL, 0);
  wchar_t *value;
  if (size <= 1) {
    return NULL;
  }
  value = checked(calloc(size, sizeof(wchar_t)));
  GetEnvironmentVariableW(name, value, size);
  return value;
}

/* --- Flags of Java ------------------------------------------------------------------------------------------------ */

static JavaVMOption *options;
static int option_count;

/* Properties (-DNAME=VALUE) that the code page cannot hold; they are set once Java runs. */
static wchar_t **deferred_properties;
static int deferred_count;

/* In the code page of the system, in which Java takes its flags and names its own folder; NULL where letters lack. */
static char *narrow(const wchar_t *wide) {
  BOOL lost = FALSE;
  int utf8 = GetACP() == CP_UTF8;
  DWORD flags = utf8 ? 0 : WC_NO_BEST_FIT_CHARS;
  int size = WideCharToMultiByte(CP_ACP, flags, wide, -1, NULL, 0, NULL, utf8 ? NULL : &lost);
  char *result;
  if (size == 0 || lost) {
    return NULL;
  }
  result = checked(malloc(size));
  WideCharToMultiByte(CP_ACP, flags, wide, -1, result, size, NULL, NULL);
  return result;
}

static void raw_option(char *flag, void *extra) {
  options = checked(realloc(options, (option_count + 1) * sizeof *options));
  options[option_count].optionString = flag;
  options[option_count++].extraInfo = extra;
}

static void option(const wchar_t *flag) {
  char *narrowed = narrow(flag);
  if (narrowed != NULL) {
    raw_option(narrowed, NULL);
  } else if (wcsncmp(flag, L"-D", 2) == 0) {
    deferred_properties = checked(realloc(deferred_properties, (deferred_count + 1) * sizeof *deferred_properties));
    deferred_properties[deferred_count++] = text(L"%ls", flag + 2);
  } else {
    fail(L"Java cannot be given the flag %ls: the code page of this Windows lacks some of its letters", flag);
  }
}

/* Those of a text, between its spaces. */
static void options_of(wchar_t *words) {
  wchar_t *rest;
  wchar_t *word = words == NULL ? NULL : wcstok_s(words, L" \t\r\n", &rest);
  for (; word != NULL; word = wcstok_s(NULL, L" \t\r\n", &rest)) {
    option(word);
  }
}

/* Whether a list with commas has a word. */
static int list_contains(const wchar_t *list, const wchar_t *word) {
  size_t length = wcslen(word);
  const wchar_t *at;
  for (at = list; at != NULL && length > 0; at = wcschr(at, L',')) {
    at += *at == L',';
    if (wcsncmp(at, word, length) == 0 && (at[length] == 0 || at[length] == L',')) {
      return 1;
    }
  }
  return 0;
}

/* Lines "COMMAND,COMMAND FLAG FLAG": flags for some commands, or for "all". */
static void options_of_file(const wchar_t *path, const wchar_t *command) {
  wchar_t line[4096];
  FILE *file = _wfopen(path, L"r");
  if (file == NULL) {
    fail(L"%ls is missing; install the program again", path);
  }
  while (fgetws(line, 4096, file) != NULL) {
    size_t length = wcscspn(line, L" \t\r\n");
    wchar_t *flags = line + length + (line[length] != 0);
    line[length] = 0;
    if (length > 0 && line[0] != L'#' && (list_contains(line, L"all") || list_contains(line, command))) {
      options_of(flags);
    }
  }
  fclose(file);
}

/* --- Where things are --------------------------------------------------------------------------------------------- */

static int is_file(const wchar_t *path) {
  DWORD attributes = GetFileAttributesW(path);
  return attributes != INVALID_FILE_ATTRIBUTES && !(attributes & FILE_ATTRIBUTE_DIRECTORY);
}

/*
 * The program's folder. Java loads its own libraries by names in the system's code page, and expands short names
 * ("SELECT~1") before; so a folder with letters that the code page lacks is of no use.
 */
static wchar_t *home_folder(void) {
  static wchar_t path[PATH];
  int up;
  GetModuleFileNameW(NULL, path, PATH);
  for (up = java ? 3 : 1; up > 0; up--) {
    wchar_t *end = wcsrchr(path, L'\\');
    if (end != NULL) {
      *end = 0;
    }
  }
  if (narrow(path) != NULL) {
    return path;
  }
  fail(L"Java cannot run from the folder %ls, since the code page of this Windows lacks some of its letters; move the"
       L" program to a folder with a plain name",
       path);
  return NULL;
}

/* --- A picture that is seen at once ------------------------------------------------------------------------------- */

/* Java's library for it, once it shows one. */
static HMODULE picture_library;

/* A function of that library. The types are those of Java's own launcher, which alone knows the flag -splash. */
#define SPLASH(type, name) ((type)(void *)GetProcAddress(picture_library, name))

/*
 * Shows a picture until Java shows a window. The library needs jvm.dll, which is loaded. Where it cannot be shown,
 * nothing but the picture is lost.
 */
static void show_picture(const wchar_t *home, const wchar_t *path) {
  char *file = narrow(path);
  char scaled[PATH];
  float scale = 1;
  int (*init)(void);
  int (*load)(const char *);
  unsigned char (*find_scaled)(const char *, const char *, float *, char *, size_t);
  void (*set_scale)(float);
  void (*set_names)(const char *, const char *);
  if (file == NULL || !is_file(path)) {
    return;
  }
  picture_library = LoadLibraryW(text(L"%ls\\runtime\\bin\\splashscreen.dll", home));
  init = SPLASH(int (*)(void), "SplashInit");
  load = SPLASH(int (*)(const char *), "SplashLoadFile");
  find_scaled =
      SPLASH(unsigned char (*)(const char *, const char *, float *, char *, size_t), "SplashGetScaledImageName");
  set_scale = SPLASH(void (*)(float), "SplashSetScaleFactor");
  set_names = SPLASH(void (*)(const char *, const char *), "SplashSetFileJarName");
  if (picture_library == NULL || init == NULL || load == NULL || find_scaled == NULL || set_scale == NULL ||
      set_names == NULL) {
    return;
  }
  if (!find_scaled(NULL, file, &scale, scaled, sizeof scaled)) {
    strcpy(scaled, file);
  }
  init();
  set_scale(scale);
  load(scaled);
  set_names(file, NULL);
}

static void close_picture(void) {
  void (*close)(void) = picture_library == NULL ? NULL : SPLASH(void (*)(void), "SplashClose");
  if (close != NULL) {
    close();
  }
}

/* Whether a command opens a window of Swing's, and only that: the viewer's is none of Swing's. */
static int opens_window(const wchar_t *command, int count, wchar_t **arguments) {
  static const wchar_t *const none[] = {L"--apply", L"--ratings"};
  static const wchar_t *const plain[] = {L"--help", L"-h", L"--version", L"-V"};
  const wchar_t *next = count > 2 ? arguments[2] : L"";
  size_t i;
  int at;
  for (at = 1; at < count; at++) {
    for (i = 0; i < sizeof none / sizeof *none; i++) {
      if (wcsncmp(arguments[at], none[i], wcslen(none[i])) == 0) {
        return 0;
      }
    }
    for (i = 0; i < sizeof plain / sizeof *plain; i++) {
      if (wcscmp(arguments[at], plain[i]) == 0) {
        return 0;
      }
    }
  }
  return wcscmp(command, L"start") == 0 || wcscmp(command, L"enrich") == 0 ||
         (wcscmp(command, L"experiment") == 0 && (*next == 0 || wcsncmp(next, L"--study", 7) == 0));
}

/* --- The archive of classes --------------------------------------------------------------------------------------- */

/* How long Java may take for the archive, and then to be gone once it has been ended, in milliseconds. */
#define ARCHIVE_LIMIT 120000
#define END_LIMIT 10000

/* Runs a program without a window and without output, and ends it when it is late; returns whether it succeeded. */
static int run_silently(wchar_t *command_line) {
  STARTUPINFOW start = {.cb = sizeof start};
  PROCESS_INFORMATION process;
  DWORD status = 1;
  start.dwFlags = STARTF_USESTDHANDLES;
  if (!CreateProcessW(NULL, command_line, NULL, NULL, FALSE, CREATE_NO_WINDOW, NULL, NULL, &start, &process)) {
    return 0;
  }
  if (WaitForSingleObject(process.hProcess, ARCHIVE_LIMIT) == WAIT_OBJECT_0) {
    GetExitCodeProcess(process.hProcess, &status);
  } else {
    TerminateProcess(process.hProcess, 1);
    WaitForSingleObject(process.hProcess, END_LIMIT); /* It holds its files until then. */
  }
  CloseHandle(process.hThread);
  CloseHandle(process.hProcess);
  return status == 0;
}

/* Makes a file without bytes; returns whether that can be done. */
static int make_empty(const wchar_t *path) {
  HANDLE made = CreateFileW(path, GENERIC_WRITE, 0, NULL, CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, NULL);
  if (made == INVALID_HANDLE_VALUE) {
    return 0;
  }
  CloseHandle(made);
  return 1;
}

static int has_bytes(const wchar_t *path) {
  WIN32_FILE_ATTRIBUTE_DATA file;
  return GetFileAttributesExW(path, GetFileExInfoStandard, &file) && (file.nFileSizeLow | file.nFileSizeHigh) != 0;
}

/*
 * Deletes the archives of other versions of the jar, and what starts that were killed have left; what another process
 * uses stays.
 */
static void delete_archives(const wchar_t *app) {
  WIN32_FIND_DATAW found;
  HANDLE search = FindFirstFileW(text(L"%ls\\classes-*.jsa*", app), &found);
  if (search != INVALID_HANDLE_VALUE) {
    do {
      wchar_t *path = text(L"%ls\\%ls", app, found.cFileName);
      SetFileAttributesW(path, FILE_ATTRIBUTE_NORMAL); /* Java makes it read only. */
      DeleteFileW(path);
    } while (FindNextFileW(search, &found));
    FindClose(search);
  }
}

/*
 * Makes the archive at a path. One start at a time makes it; the others go without. The system takes the lock back,
 * and deletes its file, however its holder ends.
 */
static void make_archive(const wchar_t *home, const wchar_t *jar, const wchar_t *list, const wchar_t *path) {
  wchar_t *app = text(L"%ls\\app", home);
  wchar_t *temporary = text(L"%ls.%lu", path, GetCurrentProcessId());
  HANDLE lock = CreateFileW(text(L"%ls\\classes.lock", app), GENERIC_WRITE | DELETE, 0, NULL, OPEN_ALWAYS,
                            FILE_ATTRIBUTE_NORMAL | FILE_FLAG_DELETE_ON_CLOSE, NULL);
  if (lock == INVALID_HANDLE_VALUE) {
    return;
  }
  /* Another start may have made it before this one had the lock. */
  if (!is_file(path)) {
    int made;
    delete_archives(app);
    made = run_silently(text(L"\"%ls\\runtime\\bin\\javaw.exe\" -Xshare:dump -Xlog:disable"
                             L" -XX:SharedClassListFile=\"%ls\" -XX:SharedArchiveFile=\"%ls\" -cp \"%ls\"",
                             home, list, temporary, jar));
    SetFileAttributesW(temporary, FILE_ATTRIBUTE_NORMAL); /* Java makes it read only, so that nothing could delete it. */
    if (!(made || make_empty(temporary)) ||
        !MoveFileExW(temporary, path, made ? MOVEFILE_REPLACE_EXISTING : 0)) {
      DeleteFileW(temporary);
    }
  }
  CloseHandle(lock);
}

/*
 * The classes that a start needs, parsed and verified once for each jar: the first start makes that archive, where the
 * folder can be written to, and the installer makes a first start. An empty one says that it cannot be made, so that no
 * start tries it again. The name is of the jar's size and time.
 */
static wchar_t *archive(const wchar_t *home, const wchar_t *jar) {
  WIN32_FILE_ATTRIBUTE_DATA file = {0};
  wchar_t *app = text(L"%ls\\app", home);
  wchar_t *list = text(L"%ls\\classes.list", app);
  wchar_t *path;
  GetFileAttributesExW(jar, GetFileExInfoStandard, &file);
  path = text(L"%ls\\classes-%08lx%08lx%08lx.jsa", app, file.nFileSizeLow, file.ftLastWriteTime.dwHighDateTime,
              file.ftLastWriteTime.dwLowDateTime);
  if (!is_file(path) && is_file(list)) {
    make_archive(home, jar, list, path);
  }
  return has_bytes(path) ? path : NULL;
}

/* --- The virtual machine ------------------------------------------------------------------------------------------ */

static JavaVM *vm;

/* What Java said before it came up, which is why it did not. */
static char startup_messages[4096];

/* Java's messages. Before it has come up they are kept, since it may end the process then. */
static jint JNICALL on_vm_message(FILE *stream, const char *format, va_list values) {
  char line[4096];
  int length = vsnprintf(line, sizeof line, format, values);
  (void)stream; /* It is of another C library. */
  if (vm == NULL) {
    strncat(startup_messages, line, sizeof startup_messages - strlen(startup_messages) - 1);
  } else {
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), line, strlen(line), &written, NULL);
  }
  return length;
}

/* Says what kept Java from coming up: the last line that it wrote. */
static void fail_by_java(void) {
  char *end = startup_messages + strlen(startup_messages);
  char *line;
  while (end > startup_messages && (end[-1] == '\n' || end[-1] == '\r')) {
    *--end = 0;
  }
  line = strrchr(startup_messages, '\n');
  fail(L"Java cannot start: %hs; see SELECTIVE_RENDERER_JAVA_OPTS where you have set it",
       *startup_messages == 0 ? "it gives no reason" : line == NULL ? startup_messages : line + 1);
}

/* The code page of the console before this program, whose output is UTF-8; 0 where it is to stay. */
static UINT console_before;

static void speak_utf8(void) {
  DWORD mode;
  if (GetConsoleMode(GetStdHandle(STD_OUTPUT_HANDLE), &mode) || GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode)) {
    UINT page = GetConsoleOutputCP();
    if (page != CP_UTF8 && SetConsoleOutputCP(CP_UTF8)) {
      console_before = page;
    }
  }
}

/* Java calls this at its end, which may come before it is up; with JAVA_TOOL_OPTIONS it has a message even in success. */
static void JNICALL on_vm_exit(jint status) {
  if (vm == NULL && status != 0 && *startup_messages != 0) {
    fail_by_java();
  }
  if (console_before != 0) {
    SetConsoleOutputCP(console_before);
  }
  ExitProcess(status);
}

static void JNICALL on_vm_abort(void) {
  on_vm_exit(1);
}

static jstring string(JNIEnv *env, const wchar_t *wide) {
  return checked((*env)->NewString(env, (const jchar *)wide, wcslen(wide)));
}

static void set_property(JNIEnv *env, wchar_t *property) {
  wchar_t *equals = wcschr(property, L'=');
  jclass system = checked((*env)->FindClass(env, "java/lang/System"));
  jmethodID set = checked((*env)->GetStaticMethodID(env, system, "setProperty",
                                                    "(Ljava/lang/String;Ljava/lang/String;)Ljava/lang/String;"));
  if (equals != NULL) {
    *equals = 0;
    (*env)->CallStaticObjectMethod(env, system, set, string(env, property), string(env, equals + 1));
  }
}

/* What the thread of main needs. */
struct program {
  const wchar_t *main;
  int count;
  wchar_t **arguments;
};

static DWORD WINAPI run(void *given) {
  struct program *program = given;
  JavaVMInitArgs wanted = {JNI_VERSION_1_8, option_count, options, JNI_FALSE};
  HMODULE library = GetModuleHandleW(L"jvm.dll");
  jint(JNICALL * create)(JavaVM **, void **, void *) = (void *)GetProcAddress(library, "JNI_CreateJavaVM");
  JavaVM *made;
  JNIEnv *env;
  jclass type;
  jmethodID method;
  jobjectArray array;
  char *class;
  char *at;
  int i, status;

  if (create == NULL || create(&made, (void **)&env, &wanted) != JNI_OK) {
    fail_by_java();
  }
  vm = made;
  for (i = 0; i < deferred_count; i++) {
    set_property(env, deferred_properties[i]);
  }
  class = checked(narrow(program->main));
  for (at = class; *at != 0; at++) {
    *at = *at == '.' ? '/' : *at;
  }
  type = (*env)->FindClass(env, class);
  method = type == NULL ? NULL : (*env)->GetStaticMethodID(env, type, "main", "([Ljava/lang/String;)V");
  if (method == NULL) {
    (*env)->ExceptionDescribe(env);
    fail(L"the class %ls is missing; install the program again", program->main);
  }
  array = checked((*env)->NewObjectArray(env, program->count, (*env)->FindClass(env, "java/lang/String"), NULL));
  for (i = 0; i < program->count; i++) {
    jstring argument = string(env, program->arguments[i]);
    (*env)->SetObjectArrayElement(env, array, i, argument);
    (*env)->DeleteLocalRef(env, argument);
  }
  (*env)->CallStaticVoidMethod(env, type, method, array);
  status = (*env)->ExceptionCheck(env);
  if (status) {
    (*env)->ExceptionDescribe(env);
  }
  (*vm)->DetachCurrentThread(vm);
  (*vm)->DestroyJavaVM(vm); /* Waits for the other threads. */
  on_vm_exit(status);
  return status;
}

/* The bytes of the last flag -Xss, which java.exe heeds for the main thread; 0 for the default. */
static SIZE_T stack_size(void) {
  SIZE_T size = 0;
  int i;
  for (i = 0; i < option_count; i++) {
    if (strncmp(options[i].optionString, "-Xss", 4) == 0) {
      char *unit;
      size = strtoul(options[i].optionString + 4, &unit, 10);
      size *= *unit == 'g' || *unit == 'G'   ? 1 << 30
              : *unit == 'm' || *unit == 'M' ? 1 << 20
              : *unit == 'k' || *unit == 'K' ? 1 << 10
                                             : 1;
    }
  }
  return size;
}

/* --- Arguments ---------------------------------------------------------------------------------------------------- */

/* The jars of another browser: a class path, or a folder of jars. */
static wchar_t *class_path_of(wchar_t *browser, const wchar_t *jar) {
  WIN32_FIND_DATAW found;
  HANDLE search = FindFirstFileW(text(L"%ls\\*.jar", browser), &found);
  wchar_t *path = NULL;
  if (search == INVALID_HANDLE_VALUE) {
    return text(L"%ls;%ls", browser, jar);
  }
  do {
    path = path == NULL ? text(L"%ls\\%ls", browser, found.cFileName)
                        : text(L"%ls;%ls\\%ls", path, browser, found.cFileName);
  } while (FindNextFileW(search, &found));
  FindClose(search);
  return text(L"%ls;%ls", path, jar);
}

/* The flags for one of the program's commands. */
static void prepare(const wchar_t *home, const wchar_t *command, const wchar_t *subcommand) {
  wchar_t *jar = text(L"%ls\\app\\selective-renderer.jar", home);
  wchar_t *browser = environment(L"SELECTIVE_RENDERER_SAI");
  wchar_t *classes = NULL;
  if (!is_file(jar)) {
    fail(L"%ls is missing; install the program again", jar);
  }
  options_of_file(text(L"%ls\\app\\launcher.cfg", home), command);
  if (browser != NULL && (wcscmp(command, L"sai") == 0 || wcscmp(subcommand, L"sai") == 0)) {
    jar = class_path_of(browser, jar);
  } else {
    if (browser != NULL && (wcscmp(command, L"run") == 0 || wcscmp(command, L"simulate") == 0)) {
      write_error(text(L"selective-renderer: %ls runs in the embedded browser; SELECTIVE_RENDERER_SAI is for the"
                       L" command sai\n",
                       command));
    }
    classes = archive(home, jar);
  }
  options_of(environment(L"SELECTIVE_RENDERER_JAVA_OPTS"));
  if (classes != NULL) {
    option(text(L"-XX:SharedArchiveFile=%ls", classes));
  }
  if (narrow(jar) == NULL) {
    fail(L"Java cannot be given the class path %ls: the code page of this Windows lacks some of its letters", jar);
  }
  option(text(L"-Djava.class.path=%ls", jar));
  if (DESKTOP != NULL) {
    option(text(L"-Dselective-renderer.desktop=%ls", DESKTOP));
  }
}

/* As java.exe reads them, flags, the main class and its arguments; returns the place of the class. Sets the picture. */
static int prepare_java(int count, wchar_t **arguments, wchar_t **picture) {
  int at;
  for (at = 1; at < count && arguments[at][0] == L'-'; at++) {
    int path = wcscmp(arguments[at], L"-cp") == 0 || wcscmp(arguments[at], L"-classpath") == 0;
    if (path && at + 1 < count) {
      option(text(L"-Djava.class.path=%ls", arguments[++at]));
    } else if (wcsncmp(arguments[at], L"-splash:", 8) == 0) {
      *picture = arguments[at] + 8;
    } else {
      option(arguments[at]);
    }
  }
  return at;
}

int wmain(int count, wchar_t **arguments) {
  wchar_t *home = home_folder();
  wchar_t *library = text(L"%ls\\runtime\\bin\\server\\jvm.dll", home);
  wchar_t *picture = NULL;
  struct program program = {MAIN, count - 1, arguments + 1};
  HANDLE thread;

  /* Where jvm.dll and what it loads find each other; the folder that the user is in is no such place. */
  SetDllDirectoryW(text(L"%ls\\runtime\\bin", home));
  if (LoadLibraryW(library) == NULL) {
    fail(is_file(library) ? L"%ls cannot be loaded; install the program again"
                          : L"%ls is missing; install the program again",
         library);
  }
  raw_option("vfprintf", on_vm_message);
  raw_option("exit", on_vm_exit);
  raw_option("abort", on_vm_abort);
  if (java) {
    int at = prepare_java(count, arguments, &picture);
    program.main = at < count ? arguments[at] : L"";
    program.count = at < count ? count - at - 1 : 0;
    program.arguments = arguments + at + 1;
    if (picture != NULL) {
      show_picture(home, picture);
    }
  } else {
    const wchar_t *first = count > 1 ? arguments[1] : L"";
    const wchar_t *desktop = DESKTOP;
    const wchar_t *empty = desktop != NULL && wcscmp(desktop, L"run") == 0 ? L"start" : desktop;
    const wchar_t *command = desktop == NULL ? first : count > 1 ? desktop : empty;
    picture = text(L"%ls\\app\\splash.png", home);
    if (opens_window(command, count, arguments)) {
      show_picture(home, picture); /* Before the archive of classes is made, which takes its time. */
    }
    /* What the window starts in turn shows it too. */
    option(text(L"-Dselective-renderer.splash=%ls", picture));
    prepare(home, command, count > 2 ? arguments[2] : L"");
    speak_utf8();
  }
  /* As java.exe does: main has a thread of its own, with a stack of the size that Java's flags ask for. */
  thread = CreateThread(NULL, stack_size(), run, &program, STACK_SIZE_PARAM_IS_A_RESERVATION, NULL);
  WaitForSingleObject(checked(thread), INFINITE);
  return 1; /* The thread ends the process. */
}
