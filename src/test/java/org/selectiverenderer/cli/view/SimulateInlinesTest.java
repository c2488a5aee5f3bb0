package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;
import static org.selectiverenderer.cli.view.SimulateTestCase.BOX;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

/** A scene may inline files of its project; others, and Inlines without end, are told. */
class SimulateInlinesTest {
  @TempDir private Path temp;
  private SimulateTestCase folder;

  @BeforeEach
  void writePath() {
    folder = new SimulateTestCase(temp);
  }

  private static String inline(String url) {
    return "<Inline url='\"" + url + "\"'/>\n";
  }

  private SimulateTestCase.Result simulate(String nodes) {
    return folder.scene("scenes/scene.x3d", nodes).simulate("scenes/scene.x3d");
  }

  private void assertLeftOut(String url, String reason) {
    SimulateTestCase.Result result = simulate(BOX + inline(url));
    assertThat(result.messages())
        .containsExactly(
            "scenes/scene.x3d:2:%d: Inline url '%s' %s; the Inline is left out"
                .formatted(BOX.length() + 1, url, reason));
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  private void assertOutside(String url, String hint) {
    assertLeftOut(
        url,
        "points outside the folders this scene may name; --allow %s would allow it"
            .formatted(shown(folder.path(hint)).replace(shown(folder.path("")) + "/", "")));
  }

  /** Returns a path as the messages of the test case show it on every system. */
  private static String shown(Path path) {
    return path.toAbsolutePath().normalize().toString().replace('\\', '/');
  }

  private void assertInlined(String url, long polygons) {
    SimulateTestCase.Result result = simulate(inline(url));
    assertThat(result.messages()).isEmpty();
    assertThat(result.polygons()).isEqualTo(polygons);
    assertThat(result.status()).isZero();
  }

  @Test
  void anInlineThatIsMissingIsLeftOut() {
    assertLeftOut("missing.x3d", "is missing");
  }

  @ParameterizedTest
  @CsvSource({
    "../outside.x3d, ''",
    "../../outside.x3d, ..",
    "sub/../../outside.x3d, ''",
    "/etc/passwd, /etc"
  })
  void anInlineOutsideOfTheFolderIsLeftOutWhetherItIsThereOrNot(String url, String hint) {
    folder.scene("outside.x3d", BOX).scene("scenes/sub/a.x3d", BOX);
    assertOutside(url, hint);
  }

  @ParameterizedTest
  @ValueSource(strings = {"http://example.org/a.x3d", "HTTPS://example.org:80/a.x3d"})
  void theNetworkIsUsedOnlyWhereTheUserAllowsIt(String url) {
    assertLeftOut(url, "is on the network; --allow-net example.org would allow it");
  }

  @ParameterizedTest
  @ValueSource(strings = {"ftp://example.org/a.x3d", "jar:file:/a.jar!/a.x3d", "urn:inet:a"})
  void otherSchemesAreNotRead(String url) {
    assertLeftOut(
        url,
        "has an unknown scheme; only files, data: and, where allowed, http: and https: are read");
  }

  @Test
  void dataInTheUrlIsAlwaysRead() {
    assertInlined(
        "data:model/x3d+xml,<X3D version='4.0'><Scene>%s</Scene></X3D>"
            .formatted(BOX)
            .replace("<", "%3C")
            .replace("'", "%22"),
        12);
  }

  @ParameterizedTest
  @CsvSource({
    "sub, is a folder",
    "., is a folder",
    "%zz.x3d, is missing",
    "file:a b.x3d, is not a file name",
    "#Viewpoint, names no file"
  })
  void whatIsNoFileIsLeftOut(String url, String reason) {
    folder.scene("scenes/sub/a.x3d", BOX);
    assertLeftOut(url, reason);
  }

  @Test
  void aFileUrlWithinTheFolderIsRead() {
    folder.scene("scenes/a b.x3d", BOX);
    assertInlined(folder.path("scenes/a b.x3d").toUri().toString(), 12);
  }

  @Test
  void aFileUrlOutsideOfTheFolderIsLeftOut() {
    // On Windows a path without a drive is one of the current drive.
    String reason = "points outside the folders this scene may name; --allow %s would allow it";
    assertLeftOut("file:///etc/hostname", reason.formatted(shown(Path.of("/etc"))));
  }

  @ParameterizedTest
  @CsvSource({
    "Größe und Breite.x3d, Größe und Breite.x3d",
    "a%20b.x3d, a b.x3d",
    "%CE%B3%CF%81%CE%B1%CF%86%CE%B5%CE%AF%CE%BF.x3d, γραφείο.x3d",
    "γραφείο.x3d, γραφείο.x3d",
    "a+b.x3d, a+b.x3d",
    "100%.x3d, 100%.x3d",
    "a%20b.x3d, a%20b.x3d",
    "sub\\c.x3d, sub/c.x3d",
    "./sub/../d.x3d, d.x3d",
    "e.x3d#Viewpoint, e.x3d",
    "  f.x3d , f.x3d"
  })
  void namesAreReadAsPeopleWriteThem(String url, String file) {
    folder.scene("scenes/sub/c.x3d", BOX).scene("scenes/" + file, BOX);
    assertInlined(url, 12);
  }

  @Test
  void aNameThatDiffersInCaseIsToldWhereItMatters() {
    folder.scene("scenes/TrashCan.x3d", BOX);
    assumeThat(folder.path("scenes/trashcan.x3d")).doesNotExist();
    assertLeftOut(
        "trashcan.x3d",
        "is missing (there is TrashCan.x3d, which differs in upper and lower case)");
  }

  @Test
  void theFirstUrlThatCanBeReadIsTaken() {
    folder.scene("scenes/a.x3d", BOX);
    SimulateTestCase.Result result =
        simulate("<Inline url='\"http://example.org/a.x3d\" \"none.x3d\" \"a.x3d\"'/>");
    assertThat(result.messages()).isEmpty();
    assertThat(result.polygons()).isEqualTo(12);
  }

  @Test
  void anInlineWithoutUrlIsEmptyAndNoProblem() {
    SimulateTestCase.Result result = simulate(BOX + "<Inline/>");
    assertThat(result.messages())
        .containsExactly("scenes/scene.x3d:2:22: Inline has no url; the Inline is left out");
    assertThat(result.status()).isZero();
  }

  @Test
  void lineBreaksAndColoursInANameStayOutOfTheMessage() {
    SimulateTestCase.Result result = simulate(BOX + inline("a&#10;b&#x9B;c"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/scene.x3d:2:22: Inline url 'a?b?c' %s; the Inline is left out"
                .formatted(OS.WINDOWS.isCurrentOs() ? "is not a file name" : "is missing"));
  }

  @Test
  void theFolderOfVersionsBesideTheScenesMayBeNamedAndItsFilesNameEachOther() {
    folder
        .scene("inlineNodes/whole.x3d", inline("part.x3d") + inline("sub/part.x3d"))
        .scene("inlineNodes/part.x3d", BOX)
        .scene("inlineNodes/sub/part.x3d", BOX + inline("../part.x3d"))
        .scene("inlineNodes/curious.x3d", inline("../still.csv"));
    assertInlined("../inlineNodes/whole.x3d", 36);
    SimulateTestCase.Result result = simulate(inline("../inlineNodes/curious.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "inlineNodes/curious.x3d:2:1: Inline url '../still.csv' points outside the folders"
                + " this scene may name; --allow "
                + shown(folder.path(""))
                + " would allow it; the Inline is left out (the Inline at scenes/scene.x3d:2:1 names"
                + " this file)");
  }

  @Test
  @RequiresSymbolicLinks
  void linksAreFollowedAndMustNotLeadOutside() throws IOException {
    folder.scene("secret/a.x3d", BOX).scene("scenes/sub/a.x3d", BOX);
    Files.createSymbolicLink(folder.path("scenes/link.x3d"), folder.path("secret/a.x3d"));
    Files.createSymbolicLink(folder.path("scenes/in.x3d"), folder.path("scenes/sub/a.x3d"));
    Files.createSymbolicLink(folder.path("scenes/folder"), folder.path("secret"));
    Files.createSymbolicLink(folder.path("inlineNodes"), folder.path("secret"));
    Files.createSymbolicLink(folder.path("scenes/ring.x3d"), folder.path("scenes/ring.x3d"));
    assertOutside("link.x3d", "secret");
    assertOutside("folder/a.x3d", "secret");
    assertOutside("folder/none.x3d", "secret");
    assertOutside("../inlineNodes/a.x3d", "secret");
    assertLeftOut("ring.x3d", "is missing");
    assertInlined("in.x3d", 12);
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "permissions are others there")
  void aFileThatMayNotBeReadIsLeftOut() {
    folder.scene("scenes/a.x3d", BOX);
    assumeThat(folder.path("scenes/a.x3d").toFile().setReadable(false)).isTrue();
    assumeThat(Files.isReadable(folder.path("scenes/a.x3d"))).isFalse();
    SimulateTestCase.Result result = simulate(BOX + inline("a.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/scene.x3d:2:22: scenes/a.x3d cannot be read: no permission; the "
                + "Inline is left out");
  }

  @Test
  void aSceneThatIncludesItselfStopsThere() {
    SimulateTestCase.Result result = simulate(BOX + inline("scene.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/scene.x3d:2:22: scenes/scene.x3d includes itself; the Inline is left out");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void aRingOfScenesIsCutWhereItCloses() {
    folder
        .scene("scenes/b.x3d", BOX + inline("c.x3d"))
        .scene("scenes/c.x3d", BOX + inline("scene.x3d"));
    SimulateTestCase.Result result = simulate(BOX + inline("b.x3d") + inline("c.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/c.x3d:2:22: scenes/scene.x3d includes itself; the Inline is left out (the Inline"
                + " at scenes/b.x3d:2:22 names this file)");
    assertThat(result.polygons()).isEqualTo(4 * 12);
  }

  @Test
  void inlinesThatDoubleWithoutEndAreCutOff() {
    for (int i = 0; i < 40; i++) {
      String next = inline("s%d.x3d".formatted(i + 1));
      folder.scene("scenes/s%d.x3d".formatted(i), next + next);
    }
    folder.scene("scenes/s40.x3d", BOX);
    SimulateTestCase.Result result = simulate(BOX + inline("s0.x3d"));
    assertThat(result.messages()).hasSize(1);
    assertThat(result.messages().get(0))
        .matches(
            "scenes/s\\d+\\.x3d:[23]:1: with its Inlines the scene has more than "
                + "\\d+ nodes \\(an Inline counts as 30\\); the rest is left out"
                + " \\(the Inline at scenes/s\\d+\\.x3d:[23]:1 names this file\\)");
    assertThat(result.polygons()).isGreaterThanOrEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void aLongChainOfInlinesIsCutOff() {
    for (int i = 0; i < 300; i++) {
      folder.scene("scenes/s%d.x3d".formatted(i), BOX + inline("s%d.x3d".formatted(i + 1)));
    }
    SimulateTestCase.Result result = simulate(BOX + inline("s0.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/s99.x3d:2:22: Inlines are nested more than 100 deep; the Inline of"
                + " scenes/s100.x3d is left out (the Inline at scenes/s98.x3d:2:22 names this"
                + " file)");
    assertThat(result.polygons()).isEqualTo(101 * 12);
  }

  @Test
  void deepScenesWithinDeepScenesAreCutOff() {
    String open = "<Group>".repeat(240);
    String close = "</Group>".repeat(240);
    for (int i = 0; i < 6; i++) {
      folder.scene(
          "scenes/s%d.x3d".formatted(i), open + BOX + inline("s%d.x3d".formatted(i + 1)) + close);
    }
    SimulateTestCase.Result result = simulate(BOX + inline("s0.x3d"));
    assertThat(result.messages())
        .containsExactly(
            "scenes/s4.x3d:2:246: nodes and Inlines are nested more than 1000 deep; the Group is"
                + " left out (the Inline at scenes/s3.x3d:2:1702 names this file)");
    assertThat(result.polygons()).isEqualTo(5 * 12);
  }

  @Test
  void problemsOfSeveralFilesAreToldFileByFileInTheOrderOfTheScene() {
    List<String> expected = new ArrayList<>();
    StringBuilder nodes = new StringBuilder("<Bogus/>\n");
    expected.add("scenes/scene.x3d:2:1: unknown element Bogus; it and its children are left out");
    for (int i = 0; i < 20; i++) {
      String name = "f%d.x3d".formatted(i);
      nodes.append(inline(name));
      folder.scene(
          "scenes/" + name,
          // The first files are the largest, so that they are read last.
          " ".repeat((20 - i) * 5000)
              + "\n"
              + "<Bogus/>\n"
              + "<Shape><IndexedFaceSet coordIndex='7'><Coordinate/></IndexedFaceSet></Shape>\n"
              + "<Bogus/>");
      String at = "scenes/" + name;
      expected.add(
          at
              + ":3:1: unknown element Bogus; it and its children are left out (the Inline at"
              + " scenes/scene.x3d:%d:1 names this file)".formatted(3 + i));
      expected.add(
          at + ":4:8: IndexedFaceSet has a face with fewer than 3 points; 1 face is left out");
      expected.add(at + ":5:1: unknown element Bogus; it and its children are left out");
    }
    nodes.append(inline("f0.x3d")).append("<Bogus/>");
    expected.add(
        1, "scenes/scene.x3d:24:1: unknown element Bogus; it and its children are left out");
    for (int run = 0; run < 3; run++) {
      assertThat(simulate(nodes.toString()).messages()).containsExactlyElementsOf(expected);
    }
  }
}
