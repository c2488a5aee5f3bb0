package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * An area of a room: a ProximitySensor in two Transforms with the numbers of thesis Fig 76, digit
 * by digit, and the metadata of Fig 77.
 *
 * @param box DEF name of the outer Transform
 * @param sensor DEF name of the sensor
 * @param enter memory schema when the viewer enters
 * @param exit memory schema when the viewer leaves
 */
record AreaSensor(
    String box,
    String scale,
    String translation,
    String inner,
    String sensor,
    String size,
    String enter,
    String exit) {

  static final AreaSensor BOOKCASE =
      new AreaSensor(
          "boxLibrary",
          "1.078 2.368 1.338",
          "3.744 -1.93 -1.107",
          "0.0 0.8219 0.0",
          "BookcaseProx",
          "2.643 1.644 3.159",
          "BookcaseSchema",
          "OfficeSchema");

  static final AreaSensor DESK =
      new AreaSensor(
          "boxDesk",
          "1.809 2.182 1.0",
          "5.779 -1.946 0.7717",
          "0.0 0.8541 0.0",
          "DeskProx",
          "3.255 1.708 3.449",
          "DeskSchema",
          "OfficeSchema");

  static final AreaSensor SOFA =
      new AreaSensor(
          "boxLounge",
          "1.14 1.058 1.136",
          "-5.461 -1.963 0.4947",
          "0.0 1.76 0.0",
          "SofaProx",
          "5.727 3.52 4.799",
          "SofaSchema",
          "LoungeSchema");

  void write(X3dWriter xml, boolean enriched) {
    xml.open("Transform", "DEF", box, "scale", scale, "translation", translation);
    xml.open("Transform", "translation", inner);
    if (enriched) {
      xml.open("ProximitySensor", "DEF", sensor, "size", size);
      ObjectNodeWriter.set(xml, "metadata", MetadataNames.set(sensor), sensor);
      ObjectNodeWriter.string(xml, SchemaField.ENTER_TIME_SCHEMA, sensor, enter);
      ObjectNodeWriter.string(xml, SchemaField.EXIT_TIME_SCHEMA, sensor, exit);
      xml.close().close();
    } else {
      xml.empty("ProximitySensor", "DEF", sensor, "size", size);
    }
    xml.close().close();
  }
}
