package org.selectiverenderer.render.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.TestScene;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.WindowOptions;
import org.selectiverenderer.testing.ShowsWindows;

@ShowsWindows
class WorldWindowTest {
  private static final int VERSIONS = 4;
  private static final int FRAMES = 3;

  /** One version of an object, of 3,200 triangles each, is shown. */
  private static World versions() {
    StringBuilder nodes = new StringBuilder("<Switch DEF='S' whichChoice='0'>");
    for (int version = 1; version <= VERSIONS; version++) {
      nodes.append(
          "<Shape><ElevationGrid xDimension='41' zDimension='41' xSpacing='0.%d' height='%s'/></Shape>"
              .formatted(version, "0 ".repeat(41 * 41)));
    }
    return new World(TestScene.of(nodes + "</Switch>").loaded(), new ProblemCollector());
  }

  private static final class Host implements WorldController {
    private final World world = versions();
    private final boolean atOnce;
    private final List<Long> uploads = new ArrayList<>();
    private WorldWindow window;
    private double time;

    Host(boolean atOnce) {
      this.atOnce = atOnce;
    }

    @Override
    public boolean readyAtOnce() {
      return atOnce;
    }

    @Override
    public void input(InputEvent event) {}

    @Override
    public Optional<World> step() {
      time += 0.1;
      world.step(time, (viewer, now, dt) -> {});
      return Optional.of(world);
    }

    @Override
    public boolean finished() {
      return uploads.size() >= FRAMES;
    }

    @Override
    public List<String> overlay() {
      return List.of();
    }

    @Override
    public void drawn(FrameStatistics drawn) {
      uploads.add(window.uploads());
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void allOfAWorldIsOnTheCardBeforeItsFirstPictureWhereTheHostAsksForIt(boolean atOnce)
      throws InterruptedException {
    Host host = new Host(atOnce);
    host.window =
        new WorldWindow(
            new WindowSetup(
                new WindowOptions("versions", 100, 80, 0, false),
                ViewLayout.MONO,
                RenderOptions.of(ShadingMode.AUTO),
                Optional.empty(),
                Optional.empty(),
                0),
            host);
    host.window.run();
    assertThat(host.uploads).hasSizeGreaterThanOrEqualTo(FRAMES);
    if (atOnce) {
      assertThat(host.uploads).containsOnly((long) VERSIONS);
    } else {
      assertThat(host.uploads.get(0)).isEqualTo(1);
    }
  }
}
