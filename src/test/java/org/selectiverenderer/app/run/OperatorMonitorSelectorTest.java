package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.window.Monitor;

/** The ProView's eyes look at the first two monitors, the first of which is the desktop's. */
class OperatorMonitorSelectorTest {
  private static final Monitor LEFT = new Monitor(0, 0, "HDMI-1", 0, 0, 640, 480);
  private static final Monitor RIGHT = new Monitor(0, 1, "HDMI-2", 640, 0, 640, 480);
  private static final Monitor DESK = new Monitor(0, 2, "DP-1", 1280, 0, 1280, 1024);
  private static final Monitor WALL = new Monitor(0, 3, "DP-2", 2560, 0, 1920, 1080);
  private static final List<Monitor> ALL = List.of(LEFT, RIGHT, DESK, WALL);

  private final List<String> messages = new ArrayList<>();

  private Optional<Monitor> find(DisplayMode mode, String wanted, List<Monitor> monitors) {
    return OperatorMonitorSelector.of(
        presentation(mode), Optional.of(wanted).filter(w -> !w.isEmpty()), monitors, messages::add);
  }

  private static DisplayConfiguration presentation(DisplayMode mode) {
    return new DisplayConfiguration(mode, new EyeGeometry(DisplayProfile.PROVIEW_50, 0.063), false);
  }

  @Test
  void isTheFirstThatNoEyeUses() {
    assertThat(find(DisplayMode.DUAL, "", ALL)).contains(DESK);
    assertThat(messages).isEmpty();
  }

  @Test
  void isTheOneWithTheNumberOrTheName() {
    assertThat(find(DisplayMode.DUAL, "3", ALL)).contains(WALL);
    assertThat(find(DisplayMode.DUAL, "dp-2", ALL)).contains(WALL);
    assertThat(find(DisplayMode.SIDE_BY_SIDE, "0", ALL)).contains(LEFT);
  }

  @Test
  void isNeverAnEyes() {
    assertThatThrownBy(() -> find(DisplayMode.DUAL, "HDMI-2", ALL))
        .hasMessageContaining("monitor 'HDMI-2' shows the participant's right eye; name another")
        .hasMessageContaining("2: 1280x1024 at 1280,0 (DP-1)");
  }

  @Test
  void oneThatIsNotThereIsSaidWithThoseThatAre() {
    assertThatThrownBy(() -> find(DisplayMode.WINDOW, "7", List.of(LEFT, DESK)))
        .hasMessage(
            "there is no monitor '7' for the operator; there are 0: 640x480 at 0,0 (HDMI-1),"
                + " 1: 1280x1024 at 1280,0 (DP-1)");
  }

  @Test
  void whereNoneIsLeftTheKeysAreTold() {
    assertThat(find(DisplayMode.DUAL, "", List.of(LEFT, RIGHT))).isEmpty();
    assertThat(messages).singleElement().asString().contains("no monitor is left", "F9 continues");
  }

  @Test
  void besideAWindowTheDesktopDecides() {
    assertThat(find(DisplayMode.WINDOW, "", ALL)).isEmpty();
    assertThat(find(DisplayMode.DUAL, "", List.of(DESK))).as("falls back to a window").isEmpty();
    assertThat(messages).isEmpty();
    assertThat(OperatorMonitorSelector.eyesHaveMonitors(presentation(DisplayMode.DUAL), ALL))
        .isTrue();
    assertThat(
            OperatorMonitorSelector.eyesHaveMonitors(presentation(DisplayMode.DUAL), List.of(DESK)))
        .isFalse();
  }
}
