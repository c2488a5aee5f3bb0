package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.nio.file.Files;
import java.util.Arrays;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The animation of a scene is played and shown at any moment, and the document stays. */
@ShowsWindows
class AnimationBarTest extends PreviewFixture {
  /** Red in the first half of four seconds, blue in the second. */
  private static final String ANIMATED =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <Viewpoint position='0 0 3'/>
        <Shape><Appearance><UnlitMaterial DEF='Paint' emissiveColor='0 1 0'/></Appearance>
          <Box/></Shape>
        <TimeSensor DEF='Clock' cycleInterval='4' loop='true'/>
        <ColorInterpolator DEF='Colours' key='0 0.5 0.5 1' keyValue='1 0 0 1 0 0 0 0 1 0 0 1'/>
        <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Colours'
            toField='set_fraction'/>
        <ROUTE fromNode='Colours' fromField='value_changed' toNode='Paint'
            toField='emissiveColor'/>
      </Scene></X3D>
      """;

  @Test
  void theSliderShowsEveryMomentAndPlayLetsTimePass() throws Exception {
    try (PreviewWindowDriver window =
        new PreviewWindowDriver(Files.writeString(folder.resolve("scene.x3d"), ANIMATED))) {
      window.await(frame -> middle(frame) == BLUE); // the end of a cycle
      JSlider time = GuiRobot.named(window.panel, "Time of the animation", JSlider.class);
      assertThat(EventThread.get(time::isShowing)).isTrue();
      EventThread.edt(() -> time.setValue(250));
      window.await(frame -> middle(frame) == RED);
      EventThread.edt(() -> time.setValue(750));
      window.await(frame -> middle(frame) == BLUE);
      EventThread.edt(() -> time.setValue(0));
      window.await(frame -> middle(frame) == RED);
      window.screenshot("preview-animation");
      JToggleButton play = GuiRobot.named(window.panel, "Play the animation", JToggleButton.class);
      EventThread.edt(play::doClick);
      window.await(frame -> middle(frame) == BLUE);
      window.await(frame -> middle(frame) == RED);
      EventThread.edt(play::doClick);
      assertThat(window.session.document().modified()).isFalse();
    }
  }

  @Test
  void aSceneWithoutTimeSensorHasNoSlider() throws Exception {
    try (PreviewWindowDriver window = open()) {
      assertThat(
              EventThread.get(
                  () ->
                      Arrays.stream(window.panel.getComponents())
                          .filter(AnimationBar.class::isInstance)
                          .anyMatch(Component::isVisible)))
          .isFalse();
    }
  }

  @Test
  void anEarlierMomentIsInTheNextCycle() {
    AnimationPhase phase = new AnimationPhase(3, 4);
    assertThat(phase.until(1)).isCloseTo(2, within(1e-9));
    assertThat(phase.until(3.5)).isCloseTo(0.5, within(1e-9));
  }
}
