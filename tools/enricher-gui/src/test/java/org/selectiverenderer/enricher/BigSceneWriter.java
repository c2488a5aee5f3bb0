package org.selectiverenderer.enricher;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;

/**
 * Writes a scene of any size for measuring: named objects in a grid, each with an IndexedFaceSet of
 * its own, and every tenth with an area around it and a Switch of two versions. The same size gives
 * the same bytes.
 */
final class BigSceneWriter {
  private static final int POINTS = 330;
  private static final int FACES = 600;
  private static final int ROW = 40;

  private final Random random = new Random(35);
  private final StringBuilder text = new StringBuilder();

  /** Writes a scene of about so many bytes, not fewer; returns the number of its objects. */
  static int write(Path file, long bytes) throws IOException {
    BigSceneWriter scene = new BigSceneWriter();
    long written = 0;
    int objects = 0;
    try (Writer out = Files.newBufferedWriter(file, StandardCharsets.US_ASCII)) {
      scene.text.append("<?xml version='1.0' encoding='UTF-8'?>\n");
      scene.text.append("<X3D profile='Immersive' version='4.0'>\n<Scene>\n");
      scene.text.append("<Viewpoint DEF='Start' position='0 5 60'/>\n");
      while (written < bytes) {
        scene.object(objects++);
        written += scene.text.length();
        out.append(scene.text);
        scene.text.setLength(0);
      }
      out.append("</Scene>\n</X3D>\n");
    }
    return objects;
  }

  private void object(int number) {
    int x = 2 * (number % ROW - ROW / 2);
    int z = 2 * (number / ROW - ROW / 2);
    text.append("<Transform DEF='Object_" + number + "' translation='" + x + " 0 " + z + "'>\n");
    if (number % 10 == 0) {
      text.append("  <ProximitySensor DEF='Area_" + number + "' size='2 2 2'/>\n");
      text.append("  <Switch DEF='Versions_" + number + "' whichChoice='0'>\n");
      shape(FACES);
      shape(FACES / 4);
      text.append("  </Switch>\n");
    } else {
      shape(FACES);
    }
    text.append("</Transform>\n");
  }

  private void shape(int faces) {
    text.append("  <Shape>\n    <Appearance><Material diffuseColor='0.5 0.4 0.3'/></Appearance>\n");
    text.append("    <IndexedFaceSet coordIndex='");
    for (int i = 0; i < faces; i++) {
      for (int corner = 0; corner < 3; corner++) {
        text.append(random.nextInt(POINTS)).append(' ');
      }
      text.append("-1 ");
    }
    text.append("'>\n      <Coordinate point='");
    for (int i = 0; i < POINTS; i++) {
      for (int axis = 0; axis < 3; axis++) {
        text.append(String.format(Locale.ROOT, "%.4f ", random.nextDouble()));
      }
      text.append(i % 8 == 7 ? ",\n" : ", ");
    }
    text.append("'/>\n    </IndexedFaceSet>\n  </Shape>\n");
  }
}
