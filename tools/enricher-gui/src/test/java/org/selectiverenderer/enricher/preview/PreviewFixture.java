package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.EventThread;

/** A scene with an object in two versions and an area, in a window of its own. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
abstract class PreviewFixture {
  static final int GREEN = 0x00ff00;

  static final int RED = 0xff0000;

  static final int BLUE = 0x0000ff;

  static final int OUTLINE = 0xff8c00;

  /**
   * Seen from (0, 0, 10): an object in two versions in the middle, an unnamed shape at its right.
   */
  static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <NavigationInfo type='"FLY"' speed='20' headlight='true'/>
        <Background skyColor='0.5 0.5 0.5'/>
        <Viewpoint position='0 0 10'/>
        <ProximitySensor DEF='Desk' size='3 3 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
            <MetadataString containerField='value' name='exitTimeSchema' value='"OfficeSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='TrashCan' whichChoice='0'>
          <MetadataSet containerField='metadata'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"OfficeSchema"'/>
            </MetadataSet>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"DeskSchema"'/>
            </MetadataSet>
          </MetadataSet>
          <Shape DEF='Low'><Appearance><UnlitMaterial emissiveColor='0 1 0'/></Appearance>
            <Box size='1 1 1'/></Shape>
          <Shape DEF='High'><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>
            <Sphere radius='0.7'/></Shape>
        </Switch>
        <Transform translation='3 0 0'>
          <Shape><Appearance><UnlitMaterial emissiveColor='0 0 1'/></Appearance>
            <Box size='1 1 1'/></Shape>
        </Transform>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  PreviewWindowDriver open() throws Exception {
    Path scene = Files.writeString(folder.resolve("scene.x3d"), SCENE);
    PreviewWindowDriver window = new PreviewWindowDriver(scene);
    window.awaitPicture();
    return window;
  }

  static int middle(PreviewFrame frame) {
    return rgb(frame.image(), 0.5, 0.5);
  }

  static int rgb(BufferedImage image, double x, double y) {
    return image.getRGB((int) (x * image.getWidth()), (int) (y * image.getHeight())) & 0xffffff;
  }

  static long count(PreviewFrame frame, int color) {
    BufferedImage image = frame.image();
    return Arrays.stream(
            image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
        .filter(rgb -> (rgb & 0xffffff) == color)
        .count();
  }

  static void boxes(PreviewWindowDriver window, boolean shown) {
    EventThread.edt(() -> window.panel.sensorsShown(shown));
  }

  static void replace(PreviewWindowDriver window, String what, String by) {
    EventThread.edt(
        () -> {
          int at = window.session.document().text().toString().indexOf(what);
          window.session.document().type(at, at + what.length(), by);
        });
  }
}
