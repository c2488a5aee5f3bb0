package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.session.LoadedStudy;

/** Where the windows of a session open. */
class OperatorViewSettingsTest {
  private static final Monitor LEFT = new Monitor(0, 0, "HDMI-1", 0, 0, 640, 480);
  private static final Monitor RIGHT = new Monitor(0, 1, "HDMI-2", 640, 0, 640, 480);
  private static final Monitor DESK = new Monitor(0, 2, "DP-1", 1280, 0, 1280, 1024);

  @TempDir Path folder;
  private final List<String> messages = new ArrayList<>();

  private OperatorViewSettings stage(DisplayMode mode, Optional<String> wanted) throws IOException {
    Path file = StudyTemplate.write(folder.resolve("s"), Path.of("scenes/apartment.x3d"));
    return OperatorViewSettings.of(
        LoadedStudy.read(file, new ProblemCollector()).orElseThrow().study(),
        new DisplayConfiguration(mode, new EyeGeometry(DisplayProfile.PROVIEW_50, 0.063), false),
        wanted,
        false,
        List.of(LEFT, RIGHT, DESK),
        messages::add);
  }

  @Test
  void whoHasTakenOffTheDisplayReadsAtTheExperimentersMonitor() throws IOException {
    OperatorViewSettings stage = stage(DisplayMode.DUAL, Optional.empty());
    assertThat(stage.monitor()).contains(DESK);
    assertThat(stage.reading()).contains(DESK);
    assertThat(stage.pointerKept()).isTrue();
    assertThat(messages).isEmpty();
  }

  @Test
  void whoSitsBeforeAWindowReadsWhereTheDesktopPutsWindows() throws IOException {
    OperatorViewSettings stage = stage(DisplayMode.SIDE_BY_SIDE, Optional.of("DP-1"));
    assertThat(stage.monitor()).contains(DESK);
    assertThat(stage.reading()).isEmpty();
    assertThat(stage.pointerKept()).isFalse();
  }

  @Test
  void theOnlyMonitorIsTheParticipants() {
    assertThat(OperatorViewSettings.viewFits(List.of(DESK))).isFalse();
    assertThat(OperatorViewSettings.viewFits(List.of(DESK, LEFT))).isTrue();
  }
}
