package org.selectiverenderer.bench;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** Object files like those that the thesis's scenes inline: one large IndexedFaceSet each. */
final class GeneratedScenes {
  private GeneratedScenes() {}

  /** As many files as the thesis's scene inlines, about 31 MB together. */
  static List<byte[]> thesisSize() {
    List<byte[]> files = new ArrayList<>();
    for (int i = 0; i < 70; i++) {
      files.add(object(i, 11_200));
    }
    return files;
  }

  private static byte[] object(int seed, int triangles) {
    Random random = new Random(seed);
    int vertices = triangles / 2 + 2;
    StringBuilder text = new StringBuilder(64 * triangles);
    text.append(
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <X3D profile="Immersive" version="3.3">
          <head><meta name="title" content="generated"/></head>
          <Scene>
            <Transform DEF="Object" translation="1 0 -2">
              <Shape>
                <Appearance><Material diffuseColor="0.8 0.7 0.2"/></Appearance>
                <IndexedFaceSet creaseAngle="0.5" coordIndex=\"""");
    for (int i = 0; i < triangles; i++) {
      int at = random.nextInt(vertices - 3);
      text.append(at).append(' ').append(at + 1).append(' ').append(at + 2).append(" -1 ");
    }
    text.append("\">\n<Coordinate point=\"");
    for (int i = 0; i < vertices; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              "%.5f %.5f %.5f, ",
              random.nextDouble() * 4 - 2,
              random.nextDouble() * 4 - 2,
              random.nextDouble() * 4 - 2));
      if (i % 8 == 0) {
        text.append('\n');
      }
    }
    text.append("\"/><Normal vector=\"");
    for (int i = 0; i < vertices; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              "%.4f %.4f %.4f ",
              random.nextDouble() * 2 - 1,
              random.nextDouble() * 2 - 1,
              random.nextDouble() * 2 - 1));
    }
    text.append("\"/></IndexedFaceSet></Shape></Transform></Scene></X3D>\n");
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }
}
