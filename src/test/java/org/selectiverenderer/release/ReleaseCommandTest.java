package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.release.ScriptSandbox.Run;
import org.selectiverenderer.testing.RequiresProgram;

/** {@code packaging/release} in a small repository, with a Maven that makes small jars. */
@DisabledOnOs(OS.WINDOWS)
@RequiresProgram("python3")
class ReleaseCommandTest {
  private static final String CHANGELOG =
      """
      # Changelog

      ## [1.2.0] - unreleased

      Doors open; see [doors](docs/doors.md#hinges) and [Git](https://git-scm.com).

      ### Added

      - Hinges.

      ## [1.1.0] - 2025-02-03

      ### Fixed

      - Windows close.

      ## [1.0.0] - 2024-02-03

      [1.1.0]: https://example.org/compare/v1.0.0...v1.1.0
      """;

  private static final List<String> PACKERS =
      List.of(
          "dpkg-deb",
          "readelf",
          "rpmbuild",
          "zip",
          "makensis",
          "x86_64-w64-mingw32-gcc",
          "x86_64-w64-mingw32-windres");

  private static final String TRIED =
      """

      ### What was tried on which system

      | system | package |
      | --- | --- |
      | Linux | `doors_%s.deb` |
      """;

  private static final String MODULE = "modules/door/pom.xml";
  private static final String CONSUMER = "packaging/libraries/consumers/door/pom.xml";

  private static final String OF_MODULE =
      """
      <project>
        <parent>
          <version>%s</version>
        </parent>
        <dependencies>
          <version>2.1</version>
        </dependencies>
      </project>
      """;

  @TempDir private Path folder;
  private ScriptSandbox scripts;
  private OsvServer osv;

  @BeforeEach
  void aRepositoryWithAnOrigin() throws Exception {
    scripts = new ScriptSandbox(folder);
    scripts.copy("packaging/release", "packaging/releasing");
    osv = new OsvServer();
    scripts.environment.put("SELECTIVE_RENDERER_OSV", osv.address());
    scripts.write("CHANGELOG.md", CHANGELOG);
    scripts.write("CITATION.cff", "title: Doors\nversion: 1.1.0\ndate-released: 2025-02-03\n");
    scripts.write("pom.xml", "<project>\n  <version>1.2.0-SNAPSHOT</version>\n</project>\n");
    scripts.write(MODULE, OF_MODULE.formatted("1.2.0-SNAPSHOT"));
    scripts.write(CONSUMER, "<project>\n  <version>1</version>\n</project>\n");
    scripts.write("LICENSE", "MIT\n");
    for (String example : List.of("scenes/a.x3d", "inlineNodes/b.x3d", "docs/examples/c.x3d")) {
      scripts.write(example, "<X3D/>\n");
    }
    script(
        "packaging/libraries/check",
        "[ -z \"${UNUSABLE:-}\" ] || { echo no method close in Door; exit 1; }\n");
    script(
        "packaging/package",
        """
        platform=$2
        shift 2
        mkdir -p target/packages
        for type; do
          echo $type >"target/packages/$platform.$type"
          [ "${DIFFERENT_PACKAGE:-}" != $type ] || pwd >>"target/packages/$platform.$type"
        done
        """);
    scripts.write("packaging/runtimes.tsv", "platform\tarchive\tsha256\nlinux-x64\ta.whl\t0\n");
    scripts.write("packaging/parts/linux", "printf '%s' libdoor.so.1\n");
    scripts.tool(
        "ldconfig", "printf '1 lib found\\n\\tlibdoor.so.%s (libc6) => /lib\\n' ${DOORS:-1}");
    for (String tool : PACKERS) {
      scripts.tool(tool, "echo " + tool + " of the doors; echo in two lines");
    }
    scripts.write(
        "docs/install.md",
        """
        # Install

        <!-- The table is written from packaging/systems.tsv by a test. -->

        | system | package |
        | --- | --- |
        | Linux | `doors_VERSION.deb` |

        <!-- End of the table -->
        """);
    scripts.write(".gitignore", "target/\n__pycache__/\n");
    // Jars that hold the POM, and with $DIFFERENT the folder that they are built in.
    scripts.tool(
        "mvn",
        """
        [ "$*" != "-B --version" ] || { printf '\\033[1mApache Maven 3.9.9 (abc)\\033[m\\n'; exit; }
        echo "mvn in ${PWD##*/}: $*" >>"$NOTES"
        mkdir target && cp pom.xml target
        echo "org.door:hinge  2.1  MIT  below" >target/table
        [ -z "${DIFFERENT:-}" ] || pwd >>target/pom.xml
        echo '{"components": [{"group": "org.door", "name": "hinge", "version": "'${HINGE:-2.1}'",
          "licenses": [{"license": {"id": "MIT"}}]},
          {"group": "org.selectiverenderer", "name": "a-module", "version": "1.2.0"}]}' >target/bom.json
        python3 - <<END
        import zipfile
        for name in ("selective-renderer", "x3d-sai"):
            with zipfile.ZipFile(f"target/{name}.jar", "w") as jar:
                for entry, file in (("pom.xml", "pom.xml"), ("META-INF/THIRD-PARTY.txt", "table")):
                    jar.writestr(zipfile.ZipInfo(entry), open(f"target/{file}").read())
        END
        v=$(sed -n 's|^  <version>\\(.*\\)</version>$|\\1|p' pom.xml)
        cp target/x3d-sai.jar "target/selective-renderer-libraries-$v.zip"
        """);
    scripts.tool(
        "java",
        """
        sed -n 's|^  <version>\\(.*\\)</version>$|selective-renderer \\1|p' "${2%/*}/../pom.xml"
        """);
    scripts.git("init", "-q", "-b", "main");
    commit("Doors");
    scripts.git("init", "-q", "--bare", folder.resolve("origin").toString());
    scripts.git("remote", "add", "origin", folder.resolve("origin").toString());
  }

  @AfterEach
  void noServer() {
    osv.close();
  }

  @Test
  void theNotesAreTheVersionsSectionOfTheChangelogAndWhatWasTried() throws Exception {
    scripts.git("remote", "set-url", "origin", "https://example.org/doors.git");
    assertThat(release("1.2.0", "--notes").out())
        .isEqualTo(
            """
            Doors open; see [doors](https://example.org/doors/blob/v1.2.0/docs/doors.md#hinges) and \
            [Git](https://git-scm.com).

            ### Added

            - Hinges.
            """
                + TRIED.formatted("1.2.0"));
    String notes = release("1.2.0", "--notes").out();
    scripts.git("remote", "set-url", "origin", "https://me:secret@example.org/doors.git");
    assertThat(release("1.2.0", "--notes").out()).isEqualTo(notes);
    assertThat(release("1.1.0", "--notes").out())
        .isEqualTo("### Fixed\n\n- Windows close.\n" + TRIED.formatted("1.1.0"));
  }

  @Test
  void whatCannotBeReleasedIsRefusedInOneLine() throws Exception {
    refused("no version of a release", "1.2");
    refused("no version of a release", "1.2.0-SNAPSHOT");
    refused("CHANGELOG.md has no section", "1.3.0");
    refused("says nothing", "1.0.0");
    scripts.write("draft.txt", "");
    refused("draft.txt", "1.2.0");
    Files.delete(scripts.home.resolve("draft.txt"));

    scripts.git("tag", "v1.2.0");
    refused("pom.xml says 1.2.0-SNAPSHOT at the tag v1.2.0", "1.2.0");
    scripts.git("push", "-q", "origin", "v1.2.0");
    commit("Later");
    refused("v1.2.0 is at another commit", "1.2.0");
    scripts.git("tag", "-d", "v1.2.0");
    refused("origin has a tag v1.2.0 at another commit", "1.2.0");
    scripts.git("push", "-q", "origin", ":v1.2.0");
    scripts.git("tag", "v1.10.0");
    refused("1.10.0 is released already", "1.2.0");
    scripts.git("tag", "-d", "v1.10.0");

    scripts.git("checkout", "-q", "--detach");
    refused("no branch", "1.2.0");
  }

  /** The folder of a release is emptied before it is filled. */
  @Test
  void filesInTheReleasesOwnFolderCannotBeAdded() throws Exception {
    scripts.write("target/release/1.2.0/doors.msi", "an installer");
    Run run = release("1.2.0", "--add", scripts.home.resolve("target/release/1.2.0").toString());
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("add files from elsewhere").hasLineCount(1);
    assertThat(scripts.read("target/release/1.2.0/doors.msi")).isEqualTo("an installer");
  }

  @Test
  void aDryRunSaysTheStepsAndChangesNothing() throws Exception {
    String before = state();
    Run run = release("1.2.0", "--dry-run");
    assertThat(run.status()).isZero();
    assertThat(run.out())
        .contains(
            "1. commit 'Release 1.2.0'",
            "tag that commit v1.2.0",
            "'Begin 1.2.1-SNAPSHOT' on main");
    assertThat(state()).isEqualTo(before);
    assertThat(scripts.notes()).isEmpty();
  }

  @Test
  void aReleaseIsACommitATagAndFilesWithTheirSums() throws Exception {
    String before = scripts.git("rev-parse", "HEAD");
    Path extra = Files.createDirectories(folder.resolve("other systems"));
    Files.writeString(extra.resolve("doors.msi"), "an installer");
    Run run = release("1.2.0", "--add", extra.toString());
    assertThat(run.err()).doesNotContain("failed");
    assertThat(run.status()).isZero();
    assertThat(run.out())
        .contains(
            "git push origin main v1.2.0",
            "gh release create v1.2.0 --verify-tag --title 1.2.0 --notes-file ",
            "git reset --hard " + before.substring(0, 9));

    // Built twice, of the commit that is tagged; it states the version and the day everywhere.
    assertThat(scripts.notes()).hasSize(2).allMatch(note -> note.contains("-Psbom,libraries"));
    assertThat(scripts.git("show", "v1.2.0:pom.xml")).contains("<version>1.2.0</version>");
    assertThat(scripts.git("show", "v1.2.0:" + MODULE) + "\n")
        .isEqualTo(OF_MODULE.formatted("1.2.0"));
    assertThat(scripts.git("show", "v1.2.0:" + CONSUMER)).contains("<version>1</version>");
    String day = scripts.git("log", "-1", "--format=%cs", "v1.2.0");
    assertThat(scripts.git("show", "v1.2.0:CHANGELOG.md"))
        .contains("## [1.2.0] - " + day + "\n\nDoors");
    assertThat(scripts.git("show", "v1.2.0:CITATION.cff"))
        .isEqualTo("title: Doors\nversion: 1.2.0\ndate-released: " + day);
    assertThat(scripts.git("tag", "-l", "--format=%(contents)", "v1.2.0")).contains("### Added");
    assertThat(scripts.git("rev-parse", "v1.2.0~1")).isEqualTo(before);

    // Then the next version begins; nothing has left this machine.
    assertThat(scripts.git("rev-parse", "main~1")).isEqualTo(scripts.git("rev-parse", "v1.2.0^{}"));
    assertThat(scripts.read("pom.xml")).contains("<version>1.2.1-SNAPSHOT</version>");
    assertThat(scripts.read(MODULE)).isEqualTo(OF_MODULE.formatted("1.2.1-SNAPSHOT"));
    assertThat(scripts.git("status", "--porcelain")).isEmpty();
    assertThat(scripts.git("ls-remote", "origin")).isEmpty();
    assertThat(scripts.git("worktree", "list")).hasLineCount(1);

    Path made = scripts.home.resolve("target/release/1.2.0");
    for (String line : Files.readAllLines(made.resolve("SHA256SUMS"))) {
      String[] parts = line.split(" {2}");
      assertThat(ScriptSandbox.sha256(made.resolve(parts[1]))).as(parts[1]).isEqualTo(parts[0]);
    }
    try (Stream<Path> files = Files.list(made)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "selective-renderer.jar",
              "x3d-sai.jar",
              "selective-renderer-libraries-1.2.0.zip",
              "selective-renderer-examples-1.2.0.zip",
              "selective-renderer-1.2.0.cdx.json",
              "THIRD-PARTY.txt",
              "LICENSE",
              "CITATION.cff",
              "BUILD.txt",
              "linux-x64.deb",
              "linux-x64.rpm",
              "linux-x64.tar",
              "linux-arm64.deb",
              "linux-arm64.rpm",
              "linux-arm64.tar",
              "windows-x64.nsis",
              "windows-x64.zip",
              "macos-x64.app",
              "macos-arm64.app",
              "doors.msi",
              "SHA256SUMS")
          .hasSize(1 + Files.readAllLines(made.resolve("SHA256SUMS")).size());
    }
    assertThat(Files.readString(made.resolve("BUILD.txt")))
        .contains(
            "Apache Maven 3.9.9",
            scripts.git("rev-parse", "v1.2.0^{}"),
            "  git checkout v1.2.0\n  mvn -Plibraries -DskipTests clean package\n",
            "target/x3d-sai.jar target/selective-renderer-libraries-1.2.0.zip\n",
            "  # makensis: makensis of the doors\n",
            "  packaging/package --for windows-x64 nsis zip\n");
  }

  @Test
  void packagesAreThoseOfTheNamedPlatforms() throws Exception {
    assertThat(release("1.2.0", "--packages", "macos-arm64,linux-x64", "--dry-run").out())
        .contains("compare the bytes: macos-arm64 (app), linux-x64 (deb, rpm, tar)");
    assertThat(release("1.2.0", "--packages", "none", "--dry-run").out())
        .doesNotContain("packages");
    Run run = release("1.2.0", "--packages", "deb");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("there are no packages for 'deb'").hasLineCount(1);
  }

  @Test
  void aLibraryThatADebianPackageAsksForIsMissedBeforeAnythingIsBuilt() throws Exception {
    scripts.environment.put("DOORS", "2");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("libdoor.so.1 for linux-x64 deb").hasLineCount(1);
    assertThat(scripts.notes()).isEmpty();
  }

  @Test
  void whatPackagesNeedAndIsNotInstalledIsSaidBeforeAnythingIsBuilt() throws Exception {
    for (String tool : List.of("git", "python3")) {
      scripts.tool(tool, "exec " + which(tool) + " \"$@\"");
    }
    scripts.environment.put("PATH", scripts.tools().toString());
    Files.delete(scripts.tools().resolve("makensis"));
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains("makensis for windows-x64 nsis", "install Debian's nsis,")
        .hasLineCount(1);
    assertThat(scripts.notes()).isEmpty();
    assertThat(release("1.2.0", "--packages", "macos-x64", "--dry-run").status()).isZero();
  }

  @Test
  void twoPackagesThatDifferAreNoRelease() throws Exception {
    String before = state();
    scripts.environment.put("DIFFERENT_PACKAGE", "rpm");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains("two builds differ, so there is no release: linux-arm64.rpm differs");
    assertThat(state()).isEqualTo(before);
  }

  @Test
  void anAddedFileThatIsMadeHereTooIsNoRelease() throws Exception {
    Path extra = Files.createDirectories(folder.resolve("more"));
    Files.writeString(extra.resolve("linux-x64.deb"), "another");
    Run run = release("1.2.0", "--add", extra.toString());
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("linux-x64.deb was made here too");
  }

  private static Path which(String tool) {
    return Stream.of("/usr/bin", "/bin", "/usr/local/bin")
        .map(folder -> Path.of(folder, tool))
        .filter(Files::isExecutable)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void atATagThatIsThereOnlyTheFilesAreMade() throws Exception {
    release("1.2.0");
    scripts.git("checkout", "-q", "v1.2.0");
    delete("target/release/1.2.0");
    String before = state();
    Run run = release("1.2.0");
    assertThat(run.status()).isZero();
    assertThat(run.out()).doesNotContain("git push", "git reset");
    assertThat(state()).isEqualTo(before);
    assertThat(scripts.home.resolve("target/release/1.2.0/SHA256SUMS")).isNotEmptyFile();
  }

  @Test
  void aVersionBeforeAReleaseIsNotOfferedAsTheLatest() throws Exception {
    scripts.write("CHANGELOG.md", CHANGELOG.replace("[1.2.0]", "[1.2.0-rc.1]"));
    commit("A candidate");
    assertThat(release("1.2.0-rc.1").out())
        .contains("gh release create v1.2.0-rc.1 --verify-tag --title 1.2.0-rc.1 --prerelease ");
  }

  @Test
  void twoBuildsThatDifferAreNoRelease() throws Exception {
    String before = state();
    scripts.environment.put("DIFFERENT", "yes");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains(
            "two builds differ, so there is no release: selective-renderer.jar: other content in pom.xml");
    assertThat(state()).isEqualTo(before);
  }

  @Test
  void librariesThatOtherProjectsCannotUseAreNoRelease() throws Exception {
    String before = state();
    scripts.environment.put("UNUSABLE", "yes");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains("'packaging/libraries/check' failed:", "no method close in Door");
    assertThat(state()).isEqualTo(before);
  }

  @Test
  void aLibraryOfAnotherVersionThanItsLicencesIsNoRelease() throws Exception {
    String before = state();
    scripts.environment.put("HINGE", "2.2");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err())
        .contains("org.door:hinge: version 2.2 in the SBOM, 2.1 in META-INF/THIRD-PARTY.txt");
    assertThat(state()).isEqualTo(before);
  }

  @Test
  void aKnownVulnerabilityIsNoReleaseUnlessNobodyAsks() throws Exception {
    String before = state();
    osv.answer("{\"results\": [{\"vulns\": [{\"id\": \"GHSA-1\"}]}]}");
    Run run = release("1.2.0");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).endsWith("\norg.door:hinge: GHSA-1 (https://osv.dev/GHSA-1)\n");
    assertThat(state()).isEqualTo(before);
    run = release("1.2.0", "--without-advisories");
    assertThat(run.status()).isZero();
    assertThat(run.err()).contains("note: nobody has asked for known vulnerabilities");
  }

  private Run release(String... arguments) throws IOException, InterruptedException {
    return scripts.run("packaging/release", arguments);
  }

  private void refused(String why, String version) throws Exception {
    String before = scripts.git("for-each-ref");
    Run run = release(version, "--dry-run");
    assertThat(run.status()).as(why).isEqualTo(2);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).startsWith("packaging/release: ").contains(why).hasLineCount(1);
    assertThat(scripts.git("for-each-ref")).isEqualTo(before);
  }

  /** Whatever a release changes in the repository. */
  private String state() throws Exception {
    return scripts.git("status", "--porcelain", "--branch")
        + scripts.git("for-each-ref")
        + scripts.git("worktree", "list");
  }

  private void script(String name, String text) throws IOException {
    scripts.write(name, "#!/bin/sh\n" + text);
    Files.setPosixFilePermissions(
        scripts.home.resolve(name), PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  private void commit(String message) throws Exception {
    scripts.git("add", "--all");
    scripts.git("commit", "-q", "--allow-empty", "-m", message);
  }

  private void delete(String name) throws IOException {
    try (Stream<Path> files = Files.list(scripts.home.resolve(name))) {
      for (Path file : (Iterable<Path>) files::iterator) {
        Files.delete(file);
      }
    }
  }
}
