package org.selectiverenderer.hmd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.Problems;

class DisplayProfilesTest {
  private final Problems problems = new Problems();

  private Optional<DisplayProfile> parse(String text) {
    return DisplayProfiles.parse("own.json", text, problems);
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
        .contains("\"width\" is to be a number from 1.0 to 16384.0");
  }

  @Test
  void anAngleThatNoFlatPictureHasIsRefused() {
    assertThat(refused("{\"width\": 8, \"height\": 6, \"field_of_view\": {\"diagonal\": 180}}"))
        .contains("\"diagonal\" is to be a number from 1.0 to 170.0");
  }

  @Test
  void brokenJsonIsToldWithItsPlace() {
    assertThat(refused("{\"width\": 800,\n  height: 600}")).startsWith("own.json:2:");
  }

  @Test
  void aMisspeltKeyIsMentioned() {
    assertThat(
            parse(
                "{\"width\": 8, \"height\": 6, \"ipd\": 60, \"field_of_view\": {\"diagonal\": 50}}"))
        .isPresent();
    assertThat(problems.list().get(0).toString()).contains("has no \"ipd\"");
  }
}
