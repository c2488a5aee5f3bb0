package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.Eventually;

/**
 * The launcher script in a copy of the repository, with a Maven and a Java that only take notes.
 */
@DisabledOnOs(OS.WINDOWS)
class LauncherTest {
  private static final Instant LONG_AGO = Instant.parse("2020-01-01T00:00:00Z");

  /** The programs that the launcher calls, without flock. */
  private static final List<String> PROGRAMS =
      List.of(
          "sh",
          "mkdir",
          "rmdir",
          "touch",
          "find",
          "sleep",
          "mv",
          "rm",
          "cp",
          "cat",
          "grep",
          "sed",
          "locale",
          "env",
          "ls",
          "readlink",
          "awk",
          "nice");

  @TempDir private Path folder;
  private Path home;
  private Path tools;
  private final Map<String, String> environment = new HashMap<>();

  @BeforeEach
  void aRepositoryThatWasBuilt() throws IOException {
    home = folder.resolve("a home with spaces");
    tools = folder.resolve("tools");
    Files.createDirectories(home.resolve("target"));
    Files.createDirectories(home.resolve("src/main"));
    Files.copy(Path.of("selective-renderer"), home.resolve("selective-renderer"));
    Files.writeString(home.resolve("pom.xml"), "");
    Files.writeString(home.resolve("src/main/A.java"), "");
    for (String source : List.of("pom.xml", "src/main/A.java", "src/main")) {
      Files.setLastModifiedTime(home.resolve(source), FileTime.from(LONG_AGO));
    }
    Files.writeString(home.resolve("target/x3d-sai.jar"), "");
    Files.writeString(home.resolve("target/selective-renderer.jar"), "");
    // Notes "mvn"; makes the jars.
    tool(
        "mvn",
        """
        echo mvn "$@" >>"$NOTES"
        echo chatter of Maven
        [ -z "${MVN_FAILS:-}" ] || exit 1
        mkdir -p target
        touch target/x3d-sai.jar target/selective-renderer.jar
        """);
    // Notes its arguments, one in a line; fails at making archives, as some Javas do.
    tool(
        "jdk/bin/java",
        """
        case "$*" in *ClassList*) exit 1 ;; esac
        for word in "$@"; do echo "java $word" >>"$NOTES"; done
        env | grep -E '^(MALLOC|LC_ALL)' >>"$NOTES"
        cat
        exit "${JAVA_STATUS:-0}"
        """);
    javaVersion("17.0.1");
    environment.put("JAVA_HOME", tools.resolve("jdk").toString());
    environment.put("NOTES", folder.resolve("notes").toString());
    environment.put("PATH", tools + ":" + System.getenv("PATH"));
  }

  @Test
  void aFreshJarIsStartedWithoutMaven() throws Exception {
    Run run = launch("validate", "a scene.x3d", "--format=json");
    assertThat(run.status()).isZero();
    assertThat(run.err()).isEmpty();
    assertThat(notes())
        .noneMatch(note -> note.startsWith("mvn"))
        .endsWith(
            "java " + jar(),
            "java org.selectiverenderer.cli.Main",
            "java validate",
            "java a scene.x3d",
            "java --format=json");
  }

  @Test
  void aMissingJarIsBuiltOnceWithOneLineOnStandardError() throws Exception {
    Files.delete(jar());
    Run run = launch("--version");
    assertThat(run.status()).isZero();
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).startsWith("selective-renderer: building").hasLineCount(1);
    launch("--version");
    assertThat(builds()).isEqualTo(1);
  }

  @Test
  void theArchiveOfClassesIsMadeAgainAtADisplayOnceDrawingHasFailed() throws Exception {
    // Draws at display :5 alone.
    tool(
        "jdk/bin/java",
        """
        case "$*" in
          *.drawing*) [ "${DISPLAY:-}" = :5 ]; exit ;;
          *-Xshare:dump*) echo dump >>"$NOTES" ;;
          *) exit 0 ;;
        esac
        for word in "$@"; do
          case $word in -XX:SharedArchiveFile=*) echo classes >"${word#*=}" ;; esac
        done
        """);
    environment.put("WAYLAND_DISPLAY", "");
    for (String display : List.of("", "", ":4", ":4", "", ":5", ":5", ":4")) {
      environment.put("DISPLAY", display);
      assertThat(launch("--version").status()).isZero();
    }
    // Without a display, at the one that cannot draw, and at the one that can; then it is whole.
    assertThat(notes()).filteredOn("dump"::equals).hasSize(3);
    try (Stream<Path> files = Files.list(home.resolve("target"))) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "selective-renderer.jar",
              "x3d-sai.jar",
              "selective-renderer-17.0.1.jsa",
              "selective-renderer-archive.jsa.lock");
    }
  }

  /** Java 21 refuses a list in which two classes have one number. */
  @Test
  void theListsOfSeveralRunsAreOneListWhoseClassesHaveNoNumbers() throws Exception {
    tool(
        "jdk/bin/java",
        """
        for word in "$@"; do
          case $word in
            -XX:DumpLoadedClassList=*)
              case $word in *drawing*) id=7 ;; *) id=0 ;; esac
              { echo "java/lang/Object id: $id"
                echo "own/$id id: 1"
                echo "@lambda-proxy own/A run ()V"
                echo "loaded/Elsewhere id: 2 super: 0 source: other.jar"; } >"${word#*=}" ;;
            -XX:SharedClassListFile=*) sed 's/^/listed /' "${word#*=}" >>"$NOTES" ;;
          esac
        done
        """);
    launch("--version");
    assertThat(notes())
        .filteredOn(note -> note.startsWith("listed "))
        .containsExactly(
            "listed java/lang/Object",
            "listed own/0",
            "listed @lambda-proxy own/A run ()V",
            "listed own/7");
  }

  @Test
  void inAPackageTheJavaAndTheJarBesideItRun() throws Exception {
    Path runtime = aPackage();
    environment.put("JAVA_HOME", "/no/such/java");
    Run run = launch("validate", "a.x3d");
    assertThat(run.err()).isEmpty();
    assertThat(run.status()).isZero();
    assertThat(notes())
        .contains(
            "packaged " + runtime.getParent().resolve("app/selective-renderer.jar"),
            "packaged -Dselective-renderer.installed=true")
        .noneMatch(note -> note.startsWith("mvn"))
        .noneMatch(note -> note.startsWith("java "));
  }

  @Test
  void aPackageMakesItsArchiveOfTheClassesThatItLists() throws Exception {
    aPackage();
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    launch("--version");
    launch("--version");
    assertThat(notes()).filteredOn("packaged -Xshare:dump"::equals).hasSize(1);
    assertThat(notes()).filteredOn("listed java/lang/Object"::equals).hasSize(1);
    assertThat(notes()).noneMatch(note -> note.contains("DumpLoadedClassList"));
    try (Stream<Path> files = Files.list(home.resolve("app"))) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "selective-renderer.jar",
              "x3d-sai.jar",
              "classes.list",
              "selective-renderer-17.0.2.jsa",
              "selective-renderer-archive.jsa.lock");
    }
  }

  /** Else a first start would show nothing until the archive is made, which takes many seconds. */
  @Test
  void aFirstStartWithAWindowDoesNotWaitForTheArchive() throws Exception {
    aPackage();
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    Files.writeString(home.resolve("app/splash.png"), "a picture");
    // Makes the archive once there is a window, or too late.
    tool(
        "runtime/bin/java",
        """
        case "$*" in
          *-Xshare:dump*)
            for turn in $(seq 100); do [ -e "$WINDOW" ] || sleep 0.1; done
            echo dumped >>"$NOTES"
            for word in "$@"; do
              case $word in -XX:SharedArchiveFile=*) echo classes >"${word#*=}" ;; esac
            done
            ;;
          *)
            echo window >>"$NOTES"
            for word in "$@"; do
              case $word in -*) echo "flag $word" >>"$NOTES" ;; esac
            done
            touch "$WINDOW"
            ;;
        esac
        """);
    Files.move(
        tools.resolve("runtime/bin/java"),
        home.resolve("runtime/bin/java"),
        StandardCopyOption.REPLACE_EXISTING);
    environment.put("WINDOW", folder.resolve("window").toString());

    assertThat(launch("start").status()).isZero();
    Path archive = home.resolve("app/selective-renderer-17.0.2.jsa");
    Eventually.await("the archive", () -> Files.exists(archive));
    assertThat(notes())
        .containsSubsequence("window", "flag -splash:" + home.resolve("app/splash.png"), "dumped")
        .doesNotContain("flag -XX:SharedArchiveFile=" + archive);

    launch("start");
    assertThat(notes()).filteredOn("dumped"::equals).hasSize(1);
    assertThat(notes()).contains("flag -XX:SharedArchiveFile=" + archive);
  }

  /** Else the second would delete what the first is writing, and both would slow their windows. */
  @Test
  void twoStartsShortlyAfterOneAnotherMakeOneArchiveAtLowPriority() throws Exception {
    aPackage();
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    Files.writeString(home.resolve("app/splash.png"), "a picture");
    // Makes the archive once it may.
    tool(
        "runtime/bin/java",
        """
        case "$*" in
          *-Xshare:dump*)
            [ "$(nice)" -lt 10 ] || echo low >>"$NOTES"
            echo dumping >>"$NOTES"
            for turn in $(seq 300); do [ -e "$MAY" ] || sleep 0.1; done
            for word in "$@"; do
              case $word in -XX:SharedArchiveFile=*) echo classes >"${word#*=}" ;; esac
            done
            ;;
          *) echo window >>"$NOTES" ;;
        esac
        """);
    Files.move(
        tools.resolve("runtime/bin/java"),
        home.resolve("runtime/bin/java"),
        StandardCopyOption.REPLACE_EXISTING);
    Path may = folder.resolve("may");
    environment.put("MAY", may.toString());

    launch("start");
    Eventually.await("the first dump", () -> notes().contains("dumping"));
    launch("start");
    launch("validate"); // In the foreground it would wait for its own.
    Files.writeString(may, "");
    Path archive = home.resolve("app/selective-renderer-17.0.2.jsa");
    Eventually.await("the archive", () -> Files.exists(archive));
    assertThat(notes()).filteredOn("dumping"::equals).hasSize(1);
    assertThat(notes()).filteredOn("window"::equals).hasSize(3);
    assertThat(notes()).contains("low");
  }

  /** Else each would delete what the other is writing. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void ofManyStartsAfterAKilledOneOneMakesTheArchive(boolean flock) throws Exception {
    aPackage();
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    // Makes the archive once it may.
    tool(
        "runtime/bin/java",
        """
        case "$*" in
          *-Xshare:dump*)
            echo dumping >>"$NOTES"
            until [ -e "$MAY" ]; do sleep 0.1; done
            for word in "$@"; do
              case $word in -XX:SharedArchiveFile=*) echo classes >"${word#*=}" ;; esac
            done
            ;;
        esac
        """);
    Files.move(
        tools.resolve("runtime/bin/java"),
        home.resolve("runtime/bin/java"),
        StandardCopyOption.REPLACE_EXISTING);
    Path may = folder.resolve("may");
    environment.put("MAY", may.toString());
    withFlock(flock);
    Path lock = home.resolve("app/selective-renderer-archive.jsa.lock");

    kill(background("validate"), () -> notes().contains("dumping"), lock);
    List<Process> starts = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      starts.add(background("validate"));
    }
    // All but the one that makes it go on without.
    Eventually.await(
        "the other starts", () -> starts.stream().filter(Process::isAlive).count() == 1);
    assertThat(notes()).filteredOn("dumping"::equals).hasSize(2);

    Files.writeString(may, "");
    for (Process each : starts) {
      assertThat(each.waitFor()).isZero();
    }
    assertThat(home.resolve("app/selective-renderer-17.0.2.jsa")).exists();
    assertThat(launch("validate").status()).isZero();
    assertThat(notes()).filteredOn("dumping"::equals).hasSize(2);
  }

  /**
   * Kills a start with all that it started, and makes its lock look like one of an hour ago.
   *
   * @param begun says when
   */
  private static void kill(Process start, Eventually.Condition begun, Path lock) throws Exception {
    Eventually.await("the first start", begun);
    List<ProcessHandle> all =
        Stream.concat(Stream.of(start.toHandle()), start.descendants()).toList();
    all.forEach(ProcessHandle::destroyForcibly);
    for (ProcessHandle each : all) {
      each.onExit().get();
    }
    Path held = lock.resolveSibling(lock.getFileName() + ".folder");
    if (Files.exists(held)) {
      Files.setLastModifiedTime(held, FileTime.from(Instant.now().minusSeconds(3600)));
    }
  }

  /** Takes flock away, which macOS does not have, or leaves it. */
  private void withFlock(boolean flock) throws IOException {
    if (flock) {
      return;
    }
    for (String name : PROGRAMS) {
      tool(name, "exec " + which(name) + " \"$@\"");
    }
    environment.put("PATH", tools.toString());
  }

  /** A participant's pictures come as fast as in later sessions. */
  @Test
  void noArchiveIsMadeBesideTheSessionsOfAStudy() throws Exception {
    aPackage();
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    Files.writeString(home.resolve("app/splash.png"), "a picture");
    tool(
        "runtime/bin/java",
        """
        case "$*" in
          *-Xshare:dump*)
            echo dumped >>"$NOTES"
            for word in "$@"; do
              case $word in -XX:SharedArchiveFile=*) echo classes >"${word#*=}" ;; esac
            done
            ;;
          *) echo window >>"$NOTES" ;;
        esac
        """);
    Files.move(
        tools.resolve("runtime/bin/java"),
        home.resolve("runtime/bin/java"),
        StandardCopyOption.REPLACE_EXISTING);

    assertThat(launch("experiment").status()).isZero();
    assertThat(notes()).containsSubsequence("dumped", "window");
  }

  /** Else it would change where it is installed, which macOS may ask the user about. */
  @Test
  void anApplicationOfMacOsKeepsItsArchiveInTheUsersCaches() throws Exception {
    aPackage();
    Files.writeString(home.resolve("Info.plist"), "");
    Files.writeString(home.resolve("app/classes.list"), "java/lang/Object");
    tool(
        "runtime/bin/java",
        """
        for word in "$@"; do
          echo "packaged $word" >>"$NOTES"
          case $word in
            -Xshare:dump) dump=yes ;;
            -XX:SharedArchiveFile=*) [ -z "${dump:-}" ] || echo classes >"${word#*=}" ;;
          esac
        done
        """);
    Files.move(
        tools.resolve("runtime/bin/java"),
        home.resolve("runtime/bin/java"),
        StandardCopyOption.REPLACE_EXISTING);
    Path user = Files.createDirectories(folder.resolve("a user"));
    environment.put("HOME", user.toString());
    launch("--version");
    launch("--version");
    assertThat(notes()).filteredOn("packaged -Xshare:dump"::equals).hasSize(1);
    Path caches = user.resolve("Library/Caches/selective-renderer/classes");
    Path archive = onlyFile(caches);
    assertThat(archive.getFileName().toString()).endsWith("-17.0.2.jsa");
    assertThat(notes())
        .contains(
            "packaged -XX:SharedArchiveFile=" + archive,
            "packaged -Xdock:name=Selective Renderer",
            "packaged -Xdock:icon=" + home.resolve("Resources/selective-renderer.icns"));
    assertThat(home.resolve("app")).isDirectoryNotContaining("glob:**.jsa*");

    // Another version's archive takes its place.
    Files.writeString(home.resolve("app/selective-renderer.jar"), "another version");
    Files.setLastModifiedTime(home.resolve("app/selective-renderer.jar"), FileTime.from(LONG_AGO));
    launch("--version");
    assertThat(onlyFile(caches)).isNotEqualTo(archive);
  }

  private static Path onlyFile(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> all = files.filter(file -> !file.toString().endsWith(".lock")).toList();
      assertThat(all).hasSize(1);
      return all.get(0);
    }
  }

  /** Makes of the repository what a package installs; returns the folder of its Java. */
  private Path aPackage() throws IOException {
    Files.delete(home.resolve("pom.xml"));
    Files.move(home.resolve("target"), home.resolve("app"));
    tool(
        "runtime/bin/java",
        """
        for word in "$@"; do
          echo "packaged $word" >>"$NOTES"
          case $word in
            -XX:SharedClassListFile=*) echo "listed $(cat "${word#*=}")" >>"$NOTES" ;;
          esac
        done
        """);
    Path runtime = home.resolve("runtime");
    Files.move(tools.resolve("runtime"), runtime);
    Files.writeString(runtime.resolve("release"), "JAVA_VERSION=\"17.0.2\"\n");
    return runtime;
  }

  @Test
  void anEditedSourceIsBuiltAgain() throws Exception {
    touchLater(home.resolve("src/main/A.java"));
    launch("--version");
    assertThat(builds()).isEqualTo(1);
  }

  /** Their sources may be newer, as those of a clone are; what is edited after that is built. */
  @Test
  void aReleasesJarsServeUntilASourceIsEdited() throws Exception {
    Path source = home.resolve("src/main/A.java");
    touchLater(source);
    Path note = Files.writeString(home.resolve("target/downloaded"), "1.2.0");
    launch("--version");
    assertThat(builds()).isZero();
    Instant before = Files.getLastModifiedTime(source).toInstant().minusSeconds(2);
    Files.setLastModifiedTime(note, FileTime.from(before));
    launch("--version");
    assertThat(builds()).isEqualTo(1);
  }

  @Test
  void aDeletedSourceIsBuiltAgain() throws Exception {
    Files.delete(home.resolve("src/main/A.java"));
    touchLater(home.resolve("src/main"));
    launch("--version");
    assertThat(builds()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "tools/enricher-gui/src/main/java/B.java",
        "modules/sai/src/main/java/B.java",
        "modules/x3d/pom.xml",
        "src/pom.xml"
      })
  void anEditedFileOfAnotherModuleIsBuiltAgain(String name) throws Exception {
    Path source = home.resolve(name);
    Files.createDirectories(source.getParent());
    Files.writeString(source, "");
    touchLater(source);
    launch("--version");
    assertThat(builds()).isEqualTo(1);
  }

  @Test
  void aFailedBuildShowsWhatMavenSaid() throws Exception {
    Files.delete(jar());
    environment.put("MVN_FAILS", "1");
    Run run = launch("--version");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).contains("chatter of Maven", "the build failed");
    assertThat(notes()).noneMatch(note -> note.startsWith("java"));
    environment.remove("MVN_FAILS");
    assertThat(launch("--version").status()).isZero();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void ofManyStartsAfterAKilledBuildOneBuilds(boolean flock) throws Exception {
    Files.delete(jar());
    Path may = folder.resolve("may");
    environment.put("MAY", may.toString());
    tool(
        "mvn",
        """
        echo mvn "$@" >>"$NOTES"
        until [ -e "$MAY" ]; do sleep 0.1; done
        touch target/x3d-sai.jar target/selective-renderer.jar
        """);
    withFlock(flock);
    Path lock = home.resolve("target/.launcher-build.lock");

    kill(background("--version"), () -> builds() == 1, lock);
    List<Process> starts = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      starts.add(background("--version"));
    }
    Eventually.await("the second build", () -> builds() > 1);
    Files.writeString(may, "");
    for (Process each : starts) {
      assertThat(each.waitFor()).isZero();
    }
    assertThat(builds()).isEqualTo(2);
  }

  @Test
  void exitStatusAndStandardInputPassThrough() throws Exception {
    environment.put("JAVA_STATUS", "1");
    Run run = launchWithInput("typed", "validate", "-");
    assertThat(run.status()).isEqualTo(1);
    assertThat(run.out()).isEqualTo("typed");
  }

  @Test
  void aBuildLeavesStandardInputAlone() throws Exception {
    Files.delete(jar());
    assertThat(launchWithInput("typed", "validate", "-").out()).isEqualTo("typed");
  }

  @Test
  void itWorksThroughLinksFromAnotherFolder() throws Exception {
    Path bin = Files.createDirectories(folder.resolve("bin"));
    Files.createSymbolicLink(bin.resolve("one"), home.resolve("selective-renderer"));
    Files.createSymbolicLink(bin.resolve("two"), Path.of("one"));
    Run run = start(List.of(bin.resolve("two").toString(), "--version"), "");
    assertThat(run.status()).as(run.err()).isZero();
    assertThat(notes()).contains("java " + jar());
  }

  @Test
  void ownFlagsForJavaComeAfterOurs() throws Exception {
    environment.put("SELECTIVE_RENDERER_JAVA_OPTS", "-Xmx4g -Dx=*");
    launch("--version");
    assertThat(notes())
        .containsSubsequence("java -Djoml.nounsafe=true", "java -Xmx4g", "java -Dx=*", "java -cp");
  }

  @Test
  void whatDrawsKeepsTheMemoryOfAFrameForTheNext() throws Exception {
    launch("validate", "a.x3d");
    assertThat(notes()).noneMatch(note -> note.startsWith("MALLOC_"));
    environment.put("MALLOC_TOP_PAD_", "4096");
    launch("run", "a.x3d");
    assertThat(notes())
        .contains("MALLOC_TOP_PAD_=4096", "MALLOC_ARENA_MAX=2")
        .anyMatch(note -> note.startsWith("MALLOC_TRIM_THRESHOLD_="))
        .anyMatch(note -> note.startsWith("MALLOC_MMAP_THRESHOLD_="));
  }

  @Test
  void namesOfFilesKeepTheirLettersInTheCLocale() throws Exception {
    environment.put("LC_ALL", "C");
    launch("run", "a.x3d");
    assertThat(notes()).contains("LC_ALL=C.UTF-8");
  }

  @Test
  void newJavaIsToldThatNativeCodeIsMeant() throws Exception {
    launch("--version");
    assertThat(notes()).doesNotContain("java --enable-native-access=ALL-UNNAMED");
    javaVersion("25.0.3");
    launch("--version");
    assertThat(notes()).contains("java --enable-native-access=ALL-UNNAMED");
  }

  @Test
  void anotherBrowsersJarsComeBeforeOurs() throws Exception {
    Path xj3d = Files.createDirectories(folder.resolve("xj3d jars"));
    environment.put("SELECTIVE_RENDERER_SAI", xj3d.toString());
    launch("sai", "a.x3d");
    assertThat(notes()).contains("java " + xj3d + "/*:" + jar());
    environment.put("SELECTIVE_RENDERER_SAI", "sai.jar:more.jar");
    launch("sai", "a.x3d");
    assertThat(notes()).contains("java sai.jar:more.jar:" + jar());
  }

  @Test
  void onlySaiRunsInAnotherBrowserAndTheOthersSaySo() throws Exception {
    environment.put("SELECTIVE_RENDERER_SAI", "sai.jar");
    Run run = launch("run", "a.x3d");
    assertThat(run.err()).contains("run runs in the embedded browser").hasLineCount(1);
    assertThat(notes()).doesNotContain("sai.jar:");
    assertThat(launch("validate", "a.x3d").err()).isEmpty();
  }

  @Test
  void anOldJavaIsNamed() throws Exception {
    javaVersion("1.8.0_292");
    Run run = launch("--version");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("needs Java 17", "1.8.0_292").hasLineCount(1);
  }

  @Test
  void aWrongJavaHomeIsNamed() throws Exception {
    environment.put("JAVA_HOME", folder.resolve("nowhere").toString());
    Run run = launch("--version");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("JAVA_HOME", "nowhere").hasLineCount(1);
  }

  @Test
  void withoutMavenItSaysWhatToInstall() throws Exception {
    Files.delete(jar());
    Files.delete(tools.resolve("mvn"));
    for (String name : List.of("readlink", "find", "head", "sed")) {
      tool(name, "exec " + which(name) + " \"$@\"");
    }
    environment.put("PATH", tools.toString());
    Run run = launch("--version");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("install Maven").hasLineCount(1);
  }

  private static Path which(String tool) {
    return List.of("/usr/bin", "/bin").stream()
        .map(directory -> Path.of(directory, tool))
        .filter(Files::isExecutable)
        .findFirst()
        .orElseThrow();
  }

  private Path jar() {
    return home.resolve("target/selective-renderer.jar");
  }

  /** Makes a file newer than the jar, but not newer than the next build. */
  private void touchLater(Path file) throws IOException {
    Instant justBefore = Instant.now().minusSeconds(5);
    Files.setLastModifiedTime(jar(), FileTime.from(justBefore.minusSeconds(5)));
    Files.setLastModifiedTime(file, FileTime.from(justBefore));
  }

  private void javaVersion(String version) throws IOException {
    Files.writeString(tools.resolve("jdk/release"), "JAVA_VERSION=\"" + version + "\"\n");
  }

  private void tool(String name, String script) throws IOException {
    Path file = tools.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, "#!/bin/sh\n" + script);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private List<String> notes() throws IOException {
    Path notes = folder.resolve("notes");
    return Files.exists(notes) ? Files.readAllLines(notes) : List.of();
  }

  private long builds() throws IOException {
    return notes().stream().filter(note -> note.startsWith("mvn ")).count();
  }

  private Run launch(String... arguments) throws IOException, InterruptedException {
    return launchWithInput("", arguments);
  }

  private Run launchWithInput(String input, String... arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("selective-renderer").toString());
    command.addAll(List.of(arguments));
    return start(command, input);
  }

  private Run start(List<String> command, String input) throws IOException, InterruptedException {
    Path in = Files.writeString(folder.resolve("in"), input);
    Path out = folder.resolve("out");
    Path err = folder.resolve("err");
    ProcessBuilder builder =
        builder(command)
            .redirectInput(in.toFile())
            .redirectOutput(out.toFile())
            .redirectError(err.toFile());
    int status = builder.start().waitFor();
    return new Run(
        status,
        Files.readString(out, StandardCharsets.UTF_8),
        Files.readString(err, StandardCharsets.UTF_8));
  }

  /** Starts it and goes on; nothing of what it says is kept. */
  private Process background(String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("selective-renderer").toString());
    command.addAll(List.of(arguments));
    return builder(command)
        .redirectInput(new File("/dev/null"))
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  private ProcessBuilder builder(List<String> command) {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder
        .environment()
        .keySet()
        .removeIf(name -> name.startsWith("SELECTIVE_RENDERER_") || name.startsWith("MALLOC_"));
    builder.environment().putAll(environment);
    return builder;
  }

  private record Run(int status, String out, String err) {}
}
