package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.apartment.facts.ExpectancyRatings;
import org.selectiverenderer.apartment.facts.ExpectancyRatings.Ratings;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes an object of the scene: a Transform with a Switch of two Inlines (thesis Fig 73) and their
 * metadata (Fig 78), or with one Inline.
 *
 * <p>MetadataSet i describes child i: child 0 is version 1, inconsistent with the part of the room
 * that makes it so; child 1 is version 2, consistent with the room.
 */
final class ObjectNodeWriter {
  private static final String FOLDER = "../inlineNodes/";

  private final PolygonCounts counts;
  private final ExpectancyRatings expectancies;

  ObjectNodeWriter(PolygonCounts counts, ExpectancyRatings expectancies) {
    this.counts = counts;
    this.expectancies = expectancies;
  }

  void write(X3dWriter xml, PlacedObject placed, boolean enriched) {
    String object = placed.object();
    String name = placed.placement().name();
    String title = Character.toUpperCase(name.charAt(0)) + name.substring(1);
    xml.open(
        "Transform",
        "DEF",
        "Transform_" + title,
        "translation",
        FieldValueText.numbers(placed.x(), placed.y(), placed.z()),
        "rotation",
        FieldValueText.yaw(placed.yaw()));
    Counts count = counts.of(object).orElse(null);
    if (count == null) {
      inline(xml, "Inline_" + title + "_Definition", object);
    } else {
      xml.open("Switch", "DEF", "Switch_" + title, "whichChoice", "1");
      if (enriched) {
        metadata(xml, placed, title);
      }
      inline(xml, "Inline_" + title + "_v1_Definition", object + "_v1");
      inline(xml, "Inline_" + title + "_v2_Definition", object + "_v2");
      xml.close();
    }
    xml.close();
  }

  private static void inline(X3dWriter xml, String def, String file) {
    xml.empty("Inline", "DEF", def, "url", FieldValueFormatter.strings(FOLDER + file + ".x3d"));
  }

  private void metadata(X3dWriter xml, PlacedObject placed, String title) {
    String inconsistentIn =
        expectancies
            .of(placed.object())
            .filter(Ratings::revolves)
            .map(Ratings::subSchema)
            .orElse("");
    String consistentIn =
        expectancies
            .of(placed.object())
            .map(Ratings::mainSchema)
            .orElse(placed.placement().room().schema());
    set(xml, "metadata", MetadataNames.set(title), title);
    if (inconsistentIn.isEmpty()) {
      xml.empty("MetadataSet", version(title, 0));
    } else {
      xml.open("MetadataSet", version(title, 0));
      words(xml, title, 0, ConsistencyType.INCONSISTENT, ConsistencyDegree.LOW, inconsistentIn);
      xml.close();
    }
    xml.open("MetadataSet", version(title, 1));
    words(xml, title, 1, ConsistencyType.CONSISTENT, ConsistencyDegree.HIGH, consistentIn);
    xml.close().close();
  }

  private static String[] version(String title, int index) {
    return attributes("value", MetadataNames.part(title, index), title + "_v" + (index + 1));
  }

  private static void words(
      X3dWriter xml,
      String title,
      int index,
      ConsistencyType type,
      ConsistencyDegree degree,
      String schema) {
    String about = MetadataNames.ofPart(title, index);
    string(xml, SchemaField.CONSISTENCY_TYPE, about, type.spelling());
    string(xml, SchemaField.DEGREE_OF_CONSISTENCY, about, degree.spelling());
    string(xml, SchemaField.SCHEMA_BELONGINESS, about, schema);
  }

  static void set(X3dWriter xml, String field, String def, String name) {
    xml.open("MetadataSet", attributes(field, def, name));
  }

  private static String[] attributes(String field, String def, String name) {
    return new String[] {"containerField", field, "DEF", def, "name", name};
  }

  static void string(X3dWriter xml, SchemaField field, String about, String value) {
    xml.empty(
        "MetadataString",
        "containerField",
        "value",
        "DEF",
        MetadataNames.string(field, about),
        "name",
        field.spelling(),
        "value",
        FieldValueFormatter.strings(value));
  }
}
