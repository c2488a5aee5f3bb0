package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.author.ValidateCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class ValidateCommandTest {
  private static final String GOOD =
      "<?xml version='1.0'?>\n<X3D profile='Immersive' version='4.0'><Scene>%s</Scene></X3D>\n";
  private static final String ERROR = GOOD.formatted("<Switch whichChoise='0'/>");
  private static final String WARNING = GOOD.formatted("<Group DEF='a b'/>");

  @TempDir Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private String input = "";

  @BeforeEach
  void writeScenes() throws IOException {
    write("good.x3d", GOOD.formatted(""));
    write("error.x3d", ERROR);
    write("warning.x3d", WARNING);
  }

  @Test
  void ourOwnScenesAreClean() {
    assertThat(execute("validate", "scenes", "--fail-on", "warning")).isZero();
    assertThat(text(out)).contains(": 0 errors, 0 warnings, ");
    assertThat(text(err)).isEmpty();
  }

  @Test
  void theStatusFollowsTheWorstFindingAndFailOn() {
    assertThat(validate("good.x3d")).isZero();
    assertThat(validate("error.x3d")).isEqualTo(1);
    assertThat(validate("warning.x3d")).isZero();
    assertThat(validate("warning.x3d", "--fail-on", "warning")).isEqualTo(1);
    assertThat(validate("good.x3d", "--fail-on", "warning")).isZero();
  }

  @Test
  void rulesCanBeIgnoredOneByOneOrAsAGroup() {
    assertThat(validate("error.x3d", "--ignore", "SR102")).isZero();
    assertThat(validate("error.x3d", "--ignore", "sr3,sr1")).isZero();
    assertThat(validate("error.x3d", "--ignore", "SR103")).isEqualTo(1);
    assertFails("--ignore: there is no rule 'SR999'", "error.x3d", "--ignore", "SR999");
  }

  @Test
  void settingsIgnoreAndWeighRules() throws IOException {
    Path settings = write("settings.json", "{\"severities\": {\"SR135\": \"error\"}}");
    assertThat(validate("warning.x3d", "--config", settings.toString())).isEqualTo(1);
    write("settings.json", "{\"ignore\": [\"SR1\"]}");
    assertThat(validate("error.x3d", "--config", settings.toString())).isZero();
  }

  @Test
  void settingsThatMeanNothingAreStatusTwo() throws IOException {
    String name = folder.resolve("settings.json").toString();
    for (String[] bad :
        List.of(
            new String[] {
              "{\"ignroe\": []}",
              "settings.json:1:2: a settings file has no \"ignroe\"; did you mean \"ignore\"?"
                  + " The settings are not used"
            },
            new String[] {
              "{\"ignore\": [\"SR999\"]}", "settings.json:1:13: there is no rule 'SR999'"
            },
            new String[] {"{\"severities\": {\"SR102\": \"fatal\"}}", "a severity must be"},
            new String[] {
              "{\"budgets\": [{\"scope\": \"Office\"}]}", "a budget needs \"polygons\""
            },
            new String[] {
              "{\"megabytes\": -1}", "1:15: \"megabytes\" must be a number from 0; the settings"
            },
            new String[] {"{\"ignore\": [", "is not valid JSON"},
            new String[] {"{\"ignore\": [], \"ignore\": []}", "Duplicate field 'ignore'"},
            new String[] {"[]", "a settings file must be an object in braces"})) {
      write("settings.json", bad[0]);
      assertFails(bad[1], "good.x3d", "--config", name);
    }
    assertFails("no such file", "good.x3d", "--config", folder.resolve("no.json").toString());
  }

  @Test
  void aReportIsABaselineForTheNextRun() throws IOException {
    Path report = folder.resolve("old.json");
    assertThat(validate("error.x3d", "--format", "json", "--output", report.toString()))
        .isEqualTo(1);
    assertThat(text(out)).isEmpty();

    write("error.x3d", ERROR.replace("<Scene>", "<Scene>\n\n\n"));
    assertThat(validate("error.x3d", "--baseline", report.toString())).isZero();

    write("error.x3d", ERROR.replace("<Scene>", "<Scene><Group size='1'/>"));
    out.reset();
    assertThat(validate("error.x3d", "--baseline", report.toString())).isEqualTo(1);
    assertThat(text(out)).contains("Group has no field size", "1 error,");
    assertFails("is not a report", "error.x3d", "--baseline", write("other.json", "{}").toString());
  }

  @Test
  void aFolderIsNeitherSettingsNorABaseline() throws IOException {
    assertFails("is a folder, not a file", "good.x3d", "--config", folder.toString());
    assertFails("is a folder, not a file", "good.x3d", "--baseline", folder.toString());
  }

  @Test
  void aBaselineThatIsNoJsonIsToldInWordsThatAreNotTheParsers() throws IOException {
    Path settings = write("settings.json", "{\n  // Settings have comments.\n}");
    assertFails("settings.json:2:", "good.x3d", "--baseline", settings.toString());
    assertThat(text(err)).contains("is not valid JSON").doesNotContain("Feature");
  }

  @Test
  void aBaselineOfMoreFindingsThanAreKeptLetsNothingPass() throws IOException {
    Path report = folder.resolve("many.json");
    write("many.x3d", GOOD.formatted("<Group size='1'/>".repeat(10_001)));
    assertThat(validate("many.x3d", "--format", "json", "--output", report.toString()))
        .isEqualTo(1);
    assertThat(validate("many.x3d", "--baseline", report.toString())).isEqualTo(1);
  }

  @Test
  void aCommentSuppressesWhatIsInTheElementAfterIt() throws IOException {
    write(
        "error.x3d",
        GOOD.formatted(
            "\n<!-- validate-ignore SR102: kept for the old browser -->\n<Switch\n whichChoise='0'>"
                + "<Switch whichChoise='1'/></Switch>\n<Switch whichChoise='2'/>"));
    assertThat(validate("error.x3d")).isEqualTo(1);
    assertThat(text(out)).contains("1 error,").contains("error.x3d:6:9");
  }

  @Test
  void readsStandardInput() {
    input = ERROR;
    assertThat(execute("validate", "-", "--format", "json")).isEqualTo(1);
    assertThat(text(out)).contains("\"file\" : \"-\"").contains("SR102");
  }

  @Test
  void readsFoldersAndPatternsAndNamesWithSpacesAndOtherScripts() throws IOException {
    write("rooms/Το γραφείο.x3d", ERROR);
    write("rooms/.hidden/x.x3d", ERROR);
    write("rooms/notes.txt", "no scene");
    assertThat(execute("validate", folder.resolve("rooms").toString(), "--base", folder.toString()))
        .isEqualTo(1);
    assertThat(text(out)).contains("rooms/Το γραφείο.x3d:2:", "1 file: 1 error");
    out.reset();
    assertThat(execute("validate", folder + "/*.x3d", "--base", folder.toString())).isEqualTo(1);
    assertThat(text(out)).contains("3 files: 1 error, 1 warning");
    assertFails("no scene (.x3d, .x3dz, .x3dv, .x3dvz, .wrl", "rooms/*.x3dv");
  }

  @Test
  void doubleStarsStandForAnyNumberOfFoldersAndNone() throws IOException {
    write("a/deep/er/x.x3d", GOOD.formatted(""));
    write("a/x.x3d", GOOD.formatted(""));
    for (String pattern : List.of("**/*.x3d", "**/{x,good,error,warning}.x3d", "**/**/*.x3d")) {
      out.reset();
      execute("validate", folder + "/" + pattern, "--base", folder.toString());
      assertThat(text(out)).as(pattern).contains("5 files:");
    }
    out.reset();
    assertThat(execute("validate", folder + "/a/**/x.x3d", "--base", folder.toString())).isZero();
    assertThat(text(out)).contains("2 files:");
    assertFails("no scene", "**/*.x3dv");
  }

  @Test
  void namesAreRelativeReferencesInSarif() throws IOException {
    // Windows takes neither colons nor question marks in names.
    boolean windows = OS.WINDOWS.isCurrentOs();
    String name = windows ? "C 50% #1/Το é.x3d" : "C: 50% #1?/Το é.x3d";
    write(name, ERROR);
    String scene = folder.resolve(name).toString();
    assertThat(execute("validate", scene, "--base", folder.toString(), "--format", "sarif"))
        .isEqualTo(1);
    assertThat(text(out))
        .contains(
            windows
                ? "\"uri\" : \"C%2050%25%20%231/%CE%A4%CE%BF%20%C3%A9.x3d\""
                : "\"uri\" : \"C%3A%2050%25%20%231%3F/%CE%A4%CE%BF%20%C3%A9.x3d\"");
  }

  @Test
  @RequiresSymbolicLinks
  void linksInCirclesEndInALine() throws IOException {
    Files.createSymbolicLink(folder.resolve("loop"), folder);
    assertThat(execute("validate", folder.toString(), "--base", folder.toString())).isEqualTo(1);
    assertThat(text(out)).contains("3 files:");
    Files.createSymbolicLink(folder.resolve("self.x3d"), folder.resolve("self.x3d"));
    assertThat(validate("self.x3d")).isEqualTo(2);
    assertThat(text(err)).hasLineCount(1).contains("self.x3d");
  }

  @Test
  void failuresAreStatusTwoAndOneLine() {
    assertFails("no.x3d", "no.x3d");
    assertFails("does not exist", "good.x3d", "--output", folder.resolve("no/r.json").toString());
    assertFails("is a folder", "good.x3d", "--output", folder.toString());
    assertFails("--base nowhere: is not a folder", "good.x3d", "--base", "nowhere");
    err.reset();
    assertThat(execute("validate")).isEqualTo(2);
    assertThat(text(err)).contains("no PATH given; name a scene or a folder of scenes");
  }

  @Test
  void sentencesNameWhatTheUserWrote() throws IOException {
    assertFails(
        "'xml' is not a format; choose text, json, sarif, junit or github",
        "good.x3d",
        "--format",
        "xml");
    String settings = write("settings.json", "{\"ignore\": [").toString();
    assertFails("settings.json:1:13: this is not valid JSON", "good.x3d", "--config", settings);
    assertThat(text(err)).doesNotContain("Source", "byte[]", "start marker");
    assertFails("--rules lists or explains rules; it takes no PATH", "good.x3d", "--rules");
    assertFails("it takes no PATH", "good.x3d", "--explain", "SR101");
    if (Files.isWritable(Path.of("/dev/full"))) {
      assertFails("/dev/full: ", "good.x3d", "--output", "/dev/full");
    }
  }

  @Test
  void writesOverNothingThatItReads() throws IOException {
    Path settings = write("settings.json", "{}");
    Path old = write("old.json", "{\"issues\": []}");
    write("outer.x3d", GOOD.formatted("<Inline url='\"error.x3d\"'/>"));
    for (String name : List.of("outer.x3d", "error.x3d", "settings.json", "old.json")) {
      Path file = folder.resolve(name);
      String before = Files.readString(file);
      assertFails(
          "which is read",
          "outer.x3d",
          "--config",
          settings.toString(),
          "--baseline",
          old.toString(),
          "--output",
          file.toString());
      assertThat(file).content().isEqualTo(before);
    }
  }

  @Test
  void explainsItsRules() {
    assertThat(execute("validate", "--rules")).isZero();
    assertThat(text(out)).contains("SR001  error", "SR102  error");
    out.reset();
    assertThat(execute("validate", "--explain", "sr102")).isZero();
    assertThat(text(out)).contains("SR102 (error)", "Bad:", "whichChoise", "Good:", "Source: X3D");
    assertThat(execute("validate", "--explain", "SR12")).isEqualTo(2);
    assertThat(text(err)).contains("there is no rule 'SR12'; did you mean");
  }

  private void assertFails(String sentence, String name, String... options) {
    out.reset();
    err.reset();
    assertThat(validate(name, options)).isEqualTo(2);
    assertThat(text(out)).isEmpty();
    assertThat(text(err)).contains(sentence).doesNotContain("\tat ");
    assertThat(text(err).lines().filter(line -> !line.startsWith("Try '"))).hasSize(1);
  }

  private int validate(String name, String... options) {
    String[] args = new String[options.length + 2];
    args[0] = "validate";
    args[1] =
        folder
            .resolve(name.replace("*", "_"))
            .toString()
            .replace("_.x3dv", "*.x3dv")
            .replace("__" + File.separator, "**" + File.separator);
    System.arraycopy(options, 0, args, 2, options.length);
    return execute(args);
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private int execute(String... args) {
    Console console =
        new Console(
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8),
            false);
    ByteArrayInputStream in = new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8));
    return new CommandRunner(console).run(args, List.of(new ValidateCommand(console, in))).code();
  }

  private static String text(ByteArrayOutputStream stream) {
    return stream.toString(StandardCharsets.UTF_8);
  }
}
