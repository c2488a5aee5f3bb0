package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * A scene of many apartments in rows, each an Inline of {@code apartment.x3d}. The recorded walk
 * goes through the first one, whose walls hide the others. It shows how a renderer behaves as a
 * scene grows by what nobody sees.
 */
public final class StreetScene {
  /** The largest number of apartments: 154 million polygons. */
  public static final int MOST = 1_024;

  /** The distance between two apartments along both axes in metres; one is 18 m by 7 m. */
  private static final double STEP = 20;

  private StreetScene() {}

  /** Returns the name of the file for a number of apartments. */
  public static String fileName(int apartments) {
    return "street-" + apartments + ".x3d";
  }

  /**
   * Returns the text of the scene, for a file beside {@code apartment.x3d}.
   *
   * @param apartments at least 1; they stand in a square of rows, as far as they fill it
   */
  public static String text(int apartments) {
    X3dWriter xml = new X3dWriter().file("Immersive", "3.3");
    xml.open("head").meta("title", fileName(apartments));
    xml.meta("description", Pluralizer.of(apartments, "apartment") + " of the thesis in rows");
    xml.meta("generator", "./selective-renderer apartment --street " + apartments);
    xml.meta("license", "MIT").close().open("Scene");
    ApartmentSceneWriter.surroundings(xml);
    int row = (int) Math.ceil(Math.sqrt(apartments));
    for (int i = 0; i < apartments; i++) {
      String place = FieldValueText.numbers(STEP * (i % row), 0, STEP * (i / row));
      xml.open("Transform", "translation", place);
      xml.empty("Inline", "url", FieldValueFormatter.strings("apartment.x3d")).close();
    }
    return xml.finish();
  }
}
