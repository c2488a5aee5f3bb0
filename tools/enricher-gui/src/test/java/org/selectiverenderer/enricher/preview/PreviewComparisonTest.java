package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.compare.ReferenceImage;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.testing.ShowsWindows;

/** All polygons against the scene as it is shown, and versions in place. */
@ShowsWindows
class PreviewComparisonTest {
  private static final int GREEN = 0x00ff00;
  private static final int RED = 0xff0000;

  /** Seen from (0, 0, 10): an object that is a green box, and in the desk's schema a red sphere. */
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <Background skyColor='0.5 0.5 0.5'/>
        <Viewpoint position='0 0 10'/>
        <Switch DEF='TrashCan' whichChoice='0'>
          <MetadataSet containerField='metadata'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"OfficeSchema"'/>
            </MetadataSet>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"DeskSchema"'/>
            </MetadataSet>
          </MetadataSet>
          <Shape><Appearance><UnlitMaterial emissiveColor='0 1 0'/></Appearance>
            <Box size='2 2 2'/></Shape>
          <Shape><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>
            <Sphere radius='1.4'/></Shape>
        </Switch>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  private static int middle(BufferedImage image) {
    return image.getRGB(image.getWidth() / 2, image.getHeight() / 2) & 0xffffff;
  }

  private PreviewWindowDriver open() throws Exception {
    Path scene = Files.writeString(folder.resolve("scene.x3d"), SCENE);
    PreviewWindowDriver window = new PreviewWindowDriver(scene);
    window.awaitPicture();
    return window;
  }

  private static int painted(PreviewWindowDriver window, double x) {
    return EventThread.get(
        () -> {
          PreviewCanvas view = window.panel.view();
          BufferedImage image =
              new BufferedImage(view.getWidth(), view.getHeight(), BufferedImage.TYPE_INT_RGB);
          view.paint(image.getGraphics());
          int y = view.getHeight() / 2 + 14; // below the handle
          return image.getRGB((int) (x * view.getWidth()), y) & 0xffffff;
        });
  }

  private static void drag(PreviewWindowDriver window, double from, double to) {
    Point origin = EventThread.get(() -> window.panel.view().getLocationOnScreen());
    int width = EventThread.get(() -> window.panel.view().getWidth());
    int y = origin.y + EventThread.get(() -> window.panel.view().getHeight()) / 2;
    window.robot.mouseMove(origin.x + (int) (from * width), y);
    window.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    window.robot.mouseMove(origin.x + (int) (to * width), y);
    window.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    window.settle();
  }

  @Test
  void aLineIsDraggedBetweenAllPolygonsAndTheSceneAsIf() throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(
          () -> {
            window.panel.asIf(List.of("DeskSchema"));
            window.panel.compare(CompareMode.WIPE);
          });
      PreviewFrame frame =
          window.await(each -> each.compared().isPresent() && middle(each.image()) == RED);
      ReferenceImage all = frame.compared().orElseThrow();
      assertThat(middle(all.image())).isEqualTo(GREEN);
      assertThat(all.polygons()).isEqualTo(12);
      assertThat(frame.polygons()).isNotEqualTo(12);
      assertThat(all.image().getWidth()).isEqualTo(frame.image().getWidth());
      assertThat(painted(window, 0.48)).isEqualTo(GREEN);
      assertThat(painted(window, 0.52)).isEqualTo(RED);
      drag(window, 0.5, 0.75);
      assertThat(EventThread.get(() -> window.panel.view().comparison().line()))
          .isCloseTo(0.75, within(0.02));
      assertThat(painted(window, 0.52)).isEqualTo(GREEN);
      assertThat(EventThread.get(() -> window.session.selection())).isEmpty();
      window.screenshot("compare-wipe");
    }
  }

  @Test
  void twoPicturesStandSideBySideAndAreClickedBoth() throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(
          () -> {
            window.panel.asIf(List.of("DeskSchema"));
            window.panel.compare(CompareMode.BESIDE);
          });
      PreviewFrame frame =
          window.await(
              each ->
                  each.compared().isPresent()
                      && middle(each.image()) == RED
                      && each.image().getWidth()
                          == EventThread.get(() -> window.panel.view().getWidth()) / 2);
      int width = EventThread.get(() -> window.panel.view().getWidth());
      assertThat(middle(frame.compared().orElseThrow().image())).isEqualTo(GREEN);
      assertThat(painted(window, 0.25)).isEqualTo(GREEN);
      assertThat(painted(window, 0.75)).isEqualTo(RED);
      window.click(width * 3 / 4, frame.image().getHeight() / 2);
      window.await(each -> each.selected().isPresent());
      window.screenshot("compare-beside");
      EventThread.edt(() -> window.panel.compare(CompareMode.OFF));
      PreviewFrame one = window.await(each -> each.compared().isEmpty());
      assertThat(one.image().getWidth())
          .isEqualTo(EventThread.get(() -> window.panel.view().getWidth()));
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"BESIDE", "WIPE"})
  void whatIsSaidOfThePreviewIsNotWrittenOverTheOtherPicture(CompareMode mode) throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(() -> window.panel.compare(mode));
      PreviewFrame shown = window.await(each -> each.compared().isPresent());
      PreviewFrame.Label label =
          new PreviewFrame.Label(
              2,
              60,
              "A name of an area that is long",
              new SensorSchemas(List.of(), List.of()),
              Optional.empty(),
              true,
              false,
              new SourceAnchor(Optional.empty(), 1, 1));
      int other =
          EventThread.get(
              () -> {
                PreviewCanvas canvas = window.panel.view();
                canvas.show(shown.with(List.of(label), shown.revision()));
                int half = canvas.getWidth() / 2 - 2;
                BufferedImage image =
                    new BufferedImage(
                        canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
                canvas.paint(image.getGraphics());
                return changed(image, shown.compared().orElseThrow().image(), half);
              });
      assertThat(other).as("pixels over the other picture, below its title").isZero();
    }
  }

  private static int changed(BufferedImage painted, BufferedImage other, int width) {
    int changed = 0;
    for (int y = 40; y < painted.getHeight() - 6; y++) {
      for (int x = 6; x < width - 12; x++) { // between the focus frame and the line's handle
        changed += (painted.getRGB(x, y) & 0xffffff) == (other.getRGB(x, y) & 0xffffff) ? 0 : 1;
      }
    }
    return changed;
  }

  @Test
  void anObjectShowsEachOfItsVersionsInPlace() throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(
          () ->
              window.session.select(
                  window.session.document().tree().orElseThrow().named("TrashCan").orElseThrow(),
                  "the tree"));
      window.await(each -> each.selected().isPresent());
      EventThread.edt(() -> window.panel.version(+1));
      PreviewFrame other = window.await(each -> middle(each.image()) == RED);
      assertThat(other.version())
          .hasValueSatisfying(words -> assertThat(words).startsWith("TrashCan: version 2 of 2, "));
      assertThat(PreviewCanvas.lines(other)).contains(other.version().orElseThrow());
      EventThread.edt(() -> window.panel.version(0));
      PreviewFrame own = window.await(each -> middle(each.image()) == GREEN);
      assertThat(own.version()).isEmpty();
      assertThat(EventThread.get(() -> window.session.document().modified())).isFalse();
    }
  }
}
