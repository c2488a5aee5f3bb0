package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.release.ScriptSandbox.Run;

/** {@code packaging/validate} and {@code packaging/action} with releases in a folder. */
@DisabledOnOs(OS.WINDOWS)
class ReleasedProgramTest {
  @TempDir private Path folder;
  private ScriptSandbox scripts;
  private Path release;

  @BeforeEach
  void aCloneOfAReleasedVersion() throws IOException {
    scripts = new ScriptSandbox(folder);
    scripts.copy("selective-renderer", "packaging/validate", "packaging/action", "packaging/hook");
    state("1.2.0");
    // Notes what it is asked to run; makes no archives of classes.
    scripts.tool(
        "jdk/bin/java",
        """
        case "$*" in *ClassList*) exit 1 ;; esac
        shift $(($# - 3))
        echo "java $*" >>"$NOTES"
        """);
    Files.writeString(scripts.tools().resolve("jdk/release"), "JAVA_VERSION=\"17.0.9\"\n");
    scripts.tool(
        "mvn",
        """
        echo mvn >>"$NOTES"
        mkdir -p target
        touch target/selective-renderer.jar target/x3d-sai.jar
        """);
    scripts.environment.put("JAVA_HOME", scripts.tools().resolve("jdk").toString());
    Path releases = folder.resolve("releases of others");
    scripts.environment.put("SELECTIVE_RENDERER_RELEASES", url(releases));
    release = Files.createDirectories(releases.resolve("v1.2.0"));
    publish("a jar");
  }

  @Test
  void downloadsTheReleaseOfItsVersionOnceAndRunsIt() throws Exception {
    Run first = validate("scene one.x3d");
    assertThat(first.status()).isZero();
    assertThat(first.err())
        .startsWith("selective-renderer: downloading version 1.2.0")
        .hasLineCount(1);
    delete(release);
    Run second = validate("scene one.x3d");
    assertThat(second.status()).isZero();
    assertThat(second.err()).isEmpty();
    assertThat(scripts.notes())
        .hasSize(2)
        .allMatch("java org.selectiverenderer.cli.Main validate scene one.x3d"::equals);
    assertThat(scripts.read("target/selective-renderer.jar")).isEqualTo("a jar");
  }

  @Test
  void aJarWithAnotherSumIsNotRun() throws Exception {
    Files.writeString(release.resolve("selective-renderer.jar"), "something else");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err().lines().skip(1))
        .singleElement()
        .asString()
        .startsWith(
            "packaging/validate: the SHA-256 sum of selective-renderer.jar is "
                + ScriptSandbox.sha256(release.resolve("selective-renderer.jar"))
                + ", not ")
        .contains("nothing was run");
    assertThat(scripts.notes()).isEmpty();
    assertThat(scripts.home.resolve("target")).isEmptyDirectory();
  }

  @Test
  void aJarThatTheListDoesNotNameIsNotRun() throws Exception {
    Files.writeString(release.resolve("SHA256SUMS"), "0123  another.jar\n");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("not in SHA256SUMS");
    assertThat(scripts.notes()).isEmpty();
  }

  @Test
  void aSumThatTheUserGivesVouchesForAllJarsByTheirList() throws Exception {
    String sum = ScriptSandbox.sha256(release.resolve("SHA256SUMS"));
    scripts.environment.put("SELECTIVE_RENDERER_SHA256", sum);
    assertThat(validate("scene.x3d").status()).isZero();
    // A later release in the place of the first, with a list that fits: only the other jar differs.
    delete(scripts.home.resolve("target"));
    publish("a jar", "interfaces of somebody else");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("sum of SHA256SUMS", "not " + sum);
    assertThat(scripts.notes()).hasSize(1);
  }

  @Test
  void jarsThatAreGoneWithTheirListAreDownloadedAgain() throws Exception {
    validate("scene.x3d");
    for (String name : List.of("selective-renderer.jar", "x3d-sai.jar", "SHA256SUMS")) {
      Files.delete(scripts.home.resolve("target").resolve(name));
    }
    Run run = validate("scene.x3d");
    assertThat(run.status()).isZero();
    assertThat(run.err()).contains("downloading").hasLineCount(1);
    assertThat(scripts.read("target/selective-renderer.jar")).isEqualTo("a jar");
  }

  @Test
  void aPasswordInTheAddressIsNotTold() throws Exception {
    scripts.environment.put("SELECTIVE_RENDERER_RELEASES", "file://me:secret@localhost/none");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("from file://localhost/none/v1.2.0").doesNotContain("secret");
  }

  @Test
  void aDownloadThatWasDamagedLaterIsReplaced() throws Exception {
    validate("scene.x3d");
    scripts.write("target/selective-renderer.jar", "a j");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isZero();
    assertThat(run.err()).contains("downloading");
    assertThat(scripts.read("target/selective-renderer.jar")).isEqualTo("a jar");
  }

  @Test
  void anotherVersionIsDownloadedWhenTheCopyIsUpdated() throws Exception {
    validate("scene.x3d");
    state("1.3.0");
    release = Files.createDirectories(release.resolveSibling("v1.3.0"));
    publish("a newer jar");
    assertThat(validate("scene.x3d").status()).isZero();
    assertThat(scripts.read("target/selective-renderer.jar")).isEqualTo("a newer jar");
  }

  @Test
  void aReleaseThatIsNotThereIsOneLineWithItsAddress() throws Exception {
    delete(release);
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err().lines().skip(1))
        .singleElement()
        .asString()
        .contains("cannot download file://", "v1.2.0/SHA256SUMS");
    assertThat(scripts.notes()).isEmpty();
  }

  @Test
  void withoutAnAddressItSaysWhatToSet() throws Exception {
    scripts.environment.remove("SELECTIVE_RENDERER_RELEASES");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("set SELECTIVE_RENDERER_RELEASES").hasLineCount(1);
  }

  @Test
  void betweenReleasesTheProgramIsBuilt() throws Exception {
    state("1.3.0-SNAPSHOT");
    Run run = validate("scene.x3d");
    assertThat(run.status()).isZero();
    assertThat(run.err()).contains("building").doesNotContain("downloading");
    assertThat(scripts.notes())
        .containsExactly("mvn", "java org.selectiverenderer.cli.Main validate scene.x3d");
  }

  @Test
  void theActionsInputsBecomeOptionsAndPaths() throws Exception {
    scripts.tool(
        "jdk/bin/java",
        "case \"$*\" in *ClassList*) exit 1 ;; esac\n"
            + "for word in \"$@\"; do echo \"$word\" >>\"$NOTES\"; done\n");
    // The job's own Java is too old; the machine has a newer one.
    scripts.environment.put("JAVA_HOME_17_X64", scripts.environment.get("JAVA_HOME"));
    Path old = Files.createDirectories(folder.resolve("old"));
    Files.writeString(old.resolve("release"), "JAVA_VERSION=\"11.0.2\"\n");
    scripts.environment.put("JAVA_HOME", old.toString());
    scripts.environment.put(
        "INPUT_RELEASES", scripts.environment.remove("SELECTIVE_RENDERER_RELEASES"));
    scripts.environment.put("INPUT_PATHS", "scenes\n  models/a chair.x3d \r\n\n");
    scripts.environment.put("INPUT_FAIL_ON", "warning");
    scripts.environment.put("INPUT_OPTIONS", "--base=scenes\n");
    Run run = scripts.run("packaging/action");
    assertThat(run.err()).contains("downloading version 1.2.0").hasLineCount(1);
    assertThat(run.status()).isZero();
    assertThat(scripts.notes())
        .endsWith(
            "validate",
            "--format=github",
            "--fail-on=warning",
            "--base=scenes",
            "--",
            "scenes",
            "models/a chair.x3d");
  }

  @Test
  void pathsOfAPullRequestAreNoOptionsOfTheAction() throws Exception {
    noteWords();
    scripts.environment.put("INPUT_PATHS", "--output=x.x3d\n@x.x3d\n-v.x3d");
    assertThat(scripts.run("packaging/action").status()).isZero();
    assertThat(scripts.notes())
        .endsWith("validate", "--format=github", "--", "--output=x.x3d", "@x.x3d", "-v.x3d");
  }

  @Test
  void whatStrangersNameCommandsNoWorkflow() throws Exception {
    scripts.tool(
        "jdk/bin/java",
        "case \"$*\" in *ClassList*) exit 1 ;; esac\n"
            + "echo '::error file=a.x3d::the report'\n"
            + "echo '::warning::forged: no such file' >&2\nexit 1\n");
    scripts.environment.put("GITHUB_ACTIONS", "true");
    Run github = scripts.run("packaging/action");
    assertThat(github.status()).isEqualTo(1);
    assertThat(github.err()).isEmpty();
    List<String> lines = github.out().lines().toList();
    assertThat(lines).first().isEqualTo("::error file=a.x3d::the report");
    String stop = lines.get(1);
    assertThat(stop).matches("::stop-commands::[0-9a-f]{32}");
    assertThat(lines)
        .endsWith("::warning::forged: no such file", stop.replace("stop-commands::", "") + "::");

    scripts.environment.put("INPUT_FORMAT", "text");
    List<String> text = scripts.run("packaging/action").out().lines().toList();
    assertThat(text.get(0)).startsWith("::stop-commands::").isNotEqualTo(stop);
    assertThat(text).last().isEqualTo(text.get(0).replace("stop-commands::", "") + "::");
  }

  /** The names are those that pre-commit hands on: of files in the commit, whoever made it. */
  @Test
  void namesOfFilesAreNoOptionsOfTheHook() throws Exception {
    noteWords();
    List<String> names =
        List.of("--output=x.x3d", "--rules.x3d", "-.x3d", "@a.x3d", "a b.x3d", "c\nd.x3d", "*.x3d");
    for (String name : names) {
      Files.writeString(scripts.home.resolve(name), "");
    }
    Files.createSymbolicLink(scripts.home.resolve("--gone.x3d"), Path.of("nowhere"));
    Files.writeString(
        scripts.home.resolve("--ignore=SR207"), "no scene, so pre-commit leaves it out");
    String[] words =
        Stream.of(Stream.of("--ignore=SR207"), names.stream(), Stream.of("--gone.x3d"))
            .flatMap(each -> each)
            .toArray(String[]::new);
    assertThat(scripts.run("packaging/hook", words).status()).isZero();
    assertThat(scripts.notes())
        .endsWith(
            "validate",
            "--fail-on",
            "warning",
            "--ignore=SR207",
            "./--output=x.x3d",
            "./--rules.x3d",
            "./-.x3d",
            "@a.x3d",
            "a b.x3d",
            "c",
            "d.x3d",
            "*.x3d",
            "./--gone.x3d");
    assertThat(Files.readString(Path.of(".pre-commit-hooks.yaml")))
        .contains("entry: packaging/hook\n");
  }

  /** Every word that Java is given on a line of its own. */
  private void noteWords() throws IOException {
    scripts.tool(
        "jdk/bin/java",
        "case \"$*\" in *ClassList*) exit 1 ;; esac\n"
            + "for word in \"$@\"; do echo \"$word\" >>\"$NOTES\"; done\n");
  }

  @Test
  void theActionTakesTheReleasesOfItsOwnRepository() throws Exception {
    scripts.environment.remove("SELECTIVE_RENDERER_RELEASES");
    scripts.environment.put("GITHUB_SERVER_URL", url(folder.resolve("server")));
    scripts.environment.put(
        "GITHUB_ACTION_PATH", "D:\\a\\_actions\\someone\\selective-renderer\\v1.2.0");
    Run run = scripts.run("packaging/action");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains("/server/someone/selective-renderer/releases/download/v1.2.0/SHA256SUMS");
  }

  @Test
  void everyInputOfTheActionReachesItsScriptAndIsExplained() throws IOException {
    String action = Files.readString(Path.of("action.yml"));
    String script = Files.readString(Path.of("packaging/action"));
    String page = Files.readString(Path.of("docs/validate.md"));
    List<String> inputs =
        Pattern.compile("(?m)^  ([a-z0-9-]+):$")
            .matcher(action.substring(action.indexOf("inputs:"), action.indexOf("runs:")))
            .results()
            .map(input -> input.group(1))
            .toList();
    assertThat(inputs).contains("paths", "sha256");
    for (String input : inputs) {
      String variable = "INPUT_" + input.toUpperCase(Locale.ROOT).replace('-', '_');
      assertThat(action).contains(variable + ": ${{ inputs." + input + " }}");
      assertThat(script).contains("${" + variable + ":-");
      assertThat(page).contains("`" + input + "`");
    }
  }

  private Run validate(String... arguments) throws IOException, InterruptedException {
    return scripts.run("packaging/validate", arguments);
  }

  private void state(String version) throws IOException {
    scripts.write("pom.xml", "<project>\n  <version>" + version + "</version>\n</project>\n");
  }

  private void publish(String jar) throws IOException {
    publish(jar, "interfaces");
  }

  private void publish(String jar, String sai) throws IOException {
    Path program = Files.writeString(release.resolve("selective-renderer.jar"), jar);
    Path interfaces = Files.writeString(release.resolve("x3d-sai.jar"), sai);
    Files.writeString(
        release.resolve("SHA256SUMS"),
        "%s  selective-renderer.jar%n%s  x3d-sai.jar%n"
            .formatted(ScriptSandbox.sha256(program), ScriptSandbox.sha256(interfaces)));
  }

  private static String url(Path path) {
    return "file://" + path.toUri().getRawPath().replaceAll("/$", "");
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : (Iterable<Path>) files::iterator) {
        Files.delete(file);
      }
    }
    Files.delete(folder);
  }
}
