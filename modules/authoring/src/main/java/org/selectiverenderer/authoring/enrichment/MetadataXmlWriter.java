package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Writes metadata elements as lines of XML, laid out as in thesis Figs 52, 77 and 78. */
final class MetadataXmlWriter {
  private final UniqueNameGenerator names;
  private final char quote;
  private final String step;

  /**
   * @param quote quote character around values
   * @param step one step of indentation
   */
  MetadataXmlWriter(UniqueNameGenerator names, char quote, String step) {
    this.names = names;
    this.quote = quote;
    this.step = step;
  }

  /** Returns a MetadataSet with all metadata of an object: a MetadataSet for each version. */
  List<String> object(String object, List<ChoiceMetadata> choices) {
    List<List<String>> parts = new ArrayList<>();
    for (int i = 0; i < choices.size(); i++) {
      parts.add(part(object, i, choices.get(i)));
    }
    return object(object, parts, List.of());
  }

  /**
   * Returns a MetadataSet of an object that also contains other metadata.
   *
   * @param kept unchanged lines of other metadata
   */
  List<String> object(String object, List<List<String>> parts, List<String> kept) {
    List<List<String>> all = new ArrayList<>(parts);
    all.add(kept);
    return set("metadata", MetadataNames.set(object), object, all);
  }

  /** Returns the MetadataSet of one version. */
  List<String> part(String object, int index, ChoiceMetadata values) {
    String about = MetadataNames.ofPart(object, index);
    List<List<String>> strings = new ArrayList<>();
    SchemaFieldFormatter.of(values)
        .forEach((field, words) -> strings.add(string(field, about, words)));
    return set("value", MetadataNames.part(object, index), object + "_v" + (index + 1), strings);
  }

  /** Returns a MetadataSet with all metadata of an area. */
  List<String> sensor(String sensor, Map<SchemaField, List<String>> fields, List<String> kept) {
    List<List<String>> all = new ArrayList<>();
    fields.forEach((field, words) -> all.add(string(field, sensor, words)));
    all.add(kept);
    return set("metadata", MetadataNames.set(sensor), sensor, all);
  }

  /** Returns a MetadataString; no line for no values. */
  List<String> string(SchemaField field, String about, List<String> words) {
    if (words.isEmpty()) {
      return List.of();
    }
    return List.of(
        "<MetadataString"
            + SourceFormatter.written("containerField", "value", quote)
            + SourceFormatter.written("DEF", names.free(MetadataNames.string(field, about)), quote)
            + SourceFormatter.written("name", field.spelling(), quote)
            // Strings of an MFString are in double quotes, which would have to be escaped.
            + SourceFormatter.written("value", FieldValueFormatter.strings(words), '\'')
            + "/>");
  }

  private List<String> set(String field, String def, String name, List<List<String>> content) {
    String head =
        "<MetadataSet"
            + SourceFormatter.written("containerField", field, quote)
            + SourceFormatter.written("DEF", names.free(def), quote)
            + SourceFormatter.written("name", name, quote);
    List<String> lines = new ArrayList<>();
    content.forEach(part -> part.forEach(line -> lines.add(step + line)));
    if (lines.isEmpty()) {
      return List.of(head + "/>");
    }
    lines.add(0, head + ">");
    lines.add("</MetadataSet>");
    return lines;
  }
}
