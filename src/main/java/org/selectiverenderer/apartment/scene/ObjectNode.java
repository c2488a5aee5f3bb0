package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.apartment.facts.Expectancies;
import org.selectiverenderer.apartment.facts.Expectancies.Ratings;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.apartment.plan.Placed;
import org.selectiverenderer.modelling.DecimalText;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;
import org.selectiverenderer.schema.SchemaField;

/**
 * An object in the scene: a Transform with a Switch of two Inlines (thesis Fig 73) and what the
 * Switch's metadata says of them (Fig 78), or with one Inline.
 *
 * <p>MetadataSet i describes child i: child 0 is version 1, inconsistent with the part of the room
 * that makes it so; child 1 is version 2, consistent with the room.
 */
final class ObjectNode {
  private static final String FOLDER = "../inlineNodes/";

  private final PolygonCounts counts;
  private final Expectancies expectancies;

  ObjectNode(PolygonCounts counts, Expectancies expectancies) {
    this.counts = counts;
    this.expectancies = expectancies;
  }

  void write(XmlText xml, Placed placed, boolean enriched) {
    String object = placed.object();
    String title = Character.toUpperCase(object.charAt(0)) + object.substring(1);
    xml.open(
        "Transform",
        "DEF",
        "Transform_" + title,
        "translation",
        Values.numbers(placed.x(), placed.y(), placed.z()),
        "rotation",
        Values.yaw(placed.yaw()));
    Counts count = counts.of(object).orElse(null);
    if (count == null) {
      inline(xml, "Inline_" + title + "_Definition", object);
    } else {
      xml.open("Switch", "DEF", "Switch_" + title, "whichChoice", "1");
      if (enriched) {
        metadata(xml, placed, title, count);
      }
      inline(xml, "Inline_" + title + "_v1_Definition", object + "_v1");
      inline(xml, "Inline_" + title + "_v2_Definition", object + "_v2");
      xml.close();
    }
    xml.close();
  }

  private static void inline(XmlText xml, String def, String file) {
    xml.empty("Inline", "DEF", def, "url", Values.quoted(FOLDER + file + ".x3d"));
  }

  private void metadata(XmlText xml, Placed placed, String title, Counts count) {
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
    set(xml, "metadata", "MetadataSet_" + title, title);
    version(xml, title, 1, count.original());
    if (!inconsistentIn.isEmpty()) {
      words(xml, title + "_Part1", ConsistencyType.INCONSISTENT, Degree.LOW, inconsistentIn);
    }
    xml.close();
    version(xml, title, 2, count.reduced());
    words(xml, title + "_Part2", ConsistencyType.CONSISTENT, Degree.HIGH, consistentIn);
    xml.close();
    xml.close();
  }

  private static void version(XmlText xml, String title, int number, int polygons) {
    set(xml, "value", "MetadataSet_" + title + "_Part" + number, title + "_v" + number);
    xml.empty(
        "MetadataInteger",
        "containerField",
        "value",
        "name",
        "polygons",
        "value",
        DecimalText.of(polygons, 0));
  }

  private static void words(
      XmlText xml, String suffix, ConsistencyType type, Degree degree, String schema) {
    string(xml, SchemaField.CONSISTENCY_TYPE, suffix, type.spelling());
    string(xml, SchemaField.DEGREE_OF_CONSISTENCY, suffix, degree.spelling());
    string(xml, SchemaField.SCHEMA_BELONGINESS, suffix, schema);
  }

  static void set(XmlText xml, String field, String def, String name) {
    xml.open("MetadataSet", "containerField", field, "DEF", def, "name", name);
  }

  static void string(XmlText xml, SchemaField field, String suffix, String value) {
    xml.empty(
        "MetadataString",
        "containerField",
        "value",
        "DEF",
        field.spelling() + suffix,
        "name",
        field.spelling(),
        "value",
        Values.quoted(value));
  }
}
