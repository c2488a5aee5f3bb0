package org.selectiverenderer.apparatus;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

class DisplayProfileLoaderTest {
  private final ProblemCollector problems = new ProblemCollector();

  private Optional<DisplayProfile> parse(String text) {
    return DisplayProfileLoader.parse("own.json", text, problems);
  }

  private String refused(String text) {
    assertThat(parse(text)).isEmpty();
    assertThat(problems.list()).isNotEmpty();
    return problems.list().get(0).toString();
  }

  @Test
  void everythingCanBeSaid() {
    DisplayProfile profile =
        parse(
                """
                {"name": "ours", "width": 1280, "height": 1024,
                 "field_of_view": {"horizontal": 48, "vertical": 39}, "overlap": 80,
                 "image_distance": 2.5,
                 "eye_offsets_mm": {"left": [1, 2, 3], "right": [0, 0, -4]},
                 "screens": {"left": 1, "right": 0}}
                """)
            .orElseThrow();
    assertThat(problems.list()).isEmpty();
    assertThat(profile.name()).isEqualTo("ours");
    assertThat(profile.fieldOfView().horizontal()).isCloseTo(48, within(1e-9));
    assertThat(profile.fieldOfView().vertical()).isCloseTo(39, within(1e-9));
    assertThat(profile.overlap()).isEqualTo(0.8);
    assertThat(profile.imageDistance()).isEqualTo(2.5);
    assertThat(profile.leftOffset()).isEqualTo(new Vector3d(0.001, 0.002, 0.003));
    assertThat(profile.screen(Eye.LEFT)).isEqualTo(1);
    assertThat(profile.screen(Eye.RIGHT)).isZero();
  }

  @Test
  void whatIsLeftOutIsThatOfAUsualDisplay() {
    DisplayProfile profile =
        parse("{\"width\": 800, \"height\": 600, \"field_of_view\": {\"diagonal\": 60}}")
            .orElseThrow();
    assertThat(profile.overlap()).isEqualTo(1);
    assertThat(profile.imageDistance()).isInfinite();
    assertThat(profile.screen(Eye.RIGHT)).isEqualTo(1);
    assertThat(profile.fieldOfView().diagonal()).isCloseTo(60, within(1e-9));
  }

  @Test
  void faultsAreToldWithWhatIsExpected() {
    assertThat(refused("{\"width\": 800, \"height\": 600}"))
        .contains("own.json", "\"field_of_view\" needs \"diagonal\"", "not used");
  }

  @Test
  void numbersOutOfRangeAreToldWithTheRange() {
    assertThat(refused("{\"width\": 0, \"height\": 1, \"field_of_view\": {\"diagonal\": 50}}"))
        .contains("own.json:1:11: \"width\" must be a number from 1 to 16384; the display profile");
  }

  @Test
  void anAngleThatNoFlatPictureHasIsRefused() {
    assertThat(refused("{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 180}}"))
        .contains("\"diagonal\" must be a number from 1 to 170");
  }

  @Test
  void brokenJsonIsToldWithItsPlace() {
    assertThat(refused("{\"width\": 800,\n  height: 600}")).startsWith("own.json:2:");
  }

  @Test
  void halfAPixelOrMonitorIsRefusedNotCutOff() {
    assertThat(
            refused("{\"width\": 640.7, \"height\": 480, \"field_of_view\": {\"diagonal\": 50}}"))
        .contains("\"width\" must be a whole number, not 640.7");
  }

  @Test
  void halfAMonitorIsRefused() {
    assertThat(
            refused(
                "{\"width\": 640, \"height\": 480, \"field_of_view\": {\"diagonal\": 50},"
                    + " \"screens\": {\"left\": 0, \"right\": 1.5}}"))
        .contains("\"right\" must be a whole number, not 1.5");
  }

  @Test
  void aMisspeltKeyInAPartIsRefusedToo() {
    refused(
        "{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 50, \"x\": 1},"
            + " \"screens\": {\"lefft\": 1}, \"eye_offsets_mm\": {\"middle\": [0, 0, 0]}}");
    assertThat(problems.list().toString())
        .contains(
            "\"field_of_view\" has no \"x\" (known keys: diagonal, horizontal, vertical)",
            "\"screens\" has no \"lefft\"; did you mean \"left\"?",
            "\"eye_offsets_mm\" has no \"middle\" (known keys: left, right)");
  }

  @Test
  void aPartThatIsNoObjectIsRefused() {
    assertThat(
            refused(
                "{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 50}, \"screens\":"
                    + " [1, 0]}"))
        .contains("\"screens\" must be an object in braces");
  }

  @Test
  void anAngleTooManyIsRefused() {
    assertThat(
            refused(
                "{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 50, \"vertical\":"
                    + " 30}}"))
        .contains("\"field_of_view\" needs");
  }

  @Test
  void anOffsetThatIsATextIsRefused() {
    assertThat(
            refused(
                "{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 50},"
                    + " \"eye_offsets_mm\": {\"left\": [\"1\", 0, 0]}}"))
        .contains("three numbers");
  }

  @Test
  void aMisspeltKeyIsRefusedSinceTheDisplayWouldNotBeTheOneMeant() {
    assertThat(
            refused(
                "{\"width\": 8, \"height\": 6,\n \"image_distanec\": 2,"
                    + " \"field_of_view\": {\"diagonal\": 50}}"))
        .isEqualTo(
            "own.json:2:2: a display profile has no \"image_distanec\";"
                + " did you mean \"image_distance\"? The display profile is not used");
  }

  @Test
  void aKeyThatIsTwiceThereIsRefused() {
    assertThat(refused("{\"width\": 8, \"width\": 9}"))
        .contains("own.json:1:", "Duplicate field 'width'");
  }

  @Test
  void nullIsAsIfTheKeyWereLeftOut() {
    DisplayProfile profile =
        parse(
                "{\"width\": 8, \"height\": 6, \"image_distance\": null, // infinity\n"
                    + "\"field_of_view\": {\"diagonal\": 50, \"vertical\": null},}")
            .orElseThrow();
    assertThat(profile.imageDistance()).isInfinite();
  }

  @Test
  void aFileThatIsNotUtf8CannotBeRead(@TempDir Path folder) throws IOException {
    byte[] latin = "{\"name\": \"M\u00f6bel\"}".getBytes(StandardCharsets.ISO_8859_1);
    Path file = Files.write(folder.resolve("own.json"), latin);
    assertThatThrownBy(() -> DisplayProfileLoader.read(file, problems))
        .isInstanceOf(IOException.class);
    assertThat(problems.list()).isEmpty();
  }
}
