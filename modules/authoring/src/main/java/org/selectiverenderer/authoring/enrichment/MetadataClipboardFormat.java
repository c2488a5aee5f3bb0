package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Converts the metadata of an object or an area to a clipboard text, and such a text to an edit.
 * Each line describes one version, or the entry or exit of an area: fields separated by tabs,
 * schemas as in an MFString.
 */
public final class MetadataClipboardFormat {
  private static final String OBJECT = "object metadata";
  private static final String AREA = "area metadata";
  private static final String TAB = "\t";
  private static final int FIELDS = 3;

  /** The parsed content of a text. */
  private record Copied(List<ChoiceMetadata> object, Optional<SensorSchemas> area) {}

  private MetadataClipboardFormat() {}

  /** Returns the text of an object's metadata. */
  public static String of(EnrichedSwitch node) {
    StringBuilder text = new StringBuilder(OBJECT).append(TAB).append(node.object()).append('\n');
    for (ChoiceMetadata values : node.values()) {
      text.append(values.type().map(ConsistencyType::spelling).orElse(""))
          .append(TAB)
          .append(values.degree().map(ConsistencyDegree::spelling).orElse(""))
          .append(TAB)
          .append(FieldValueFormatter.strings(values.schemas()))
          .append('\n');
    }
    return text.toString();
  }

  /** Returns the text of an area's metadata. */
  public static String of(EnrichedSensor node) {
    return AREA
        + TAB
        + node.name()
        + "\nenter\t"
        + FieldValueFormatter.strings(node.schemas().enter())
        + "\nexit\t"
        + FieldValueFormatter.strings(node.schemas().exit())
        + "\n";
  }

  /** Returns whether a text is metadata in this format. */
  public static boolean recognises(String text) {
    return text.startsWith(OBJECT + TAB) || text.startsWith(AREA + TAB);
  }

  /**
   * Replaces the metadata of objects or areas by that of a text. For an object with another number
   * of versions the metadata is mapped by degree, as when a cell of the table is filled.
   *
   * @throws EditRejectedException with a sentence, if the text is not metadata, or of the other
   *     kind
   */
  public static Edit paste(
      DocumentEnrichment enrichment,
      String text,
      List<EnrichedSwitch> objects,
      List<EnrichedSensor> areas) {
    if (!recognises(text)) {
      throw new EditRejectedException(
          "the clipboard contains no metadata; choose an object or an area and copy its metadata"
              + " first");
    }
    Copied copied = copied(text);
    boolean ofArea = copied.area().isPresent();
    if (ofArea ? areas.isEmpty() : objects.isEmpty()) {
      throw new EditRejectedException(
          ofArea
              ? "the clipboard has the metadata of an area; select a ProximitySensor to paste it"
              : "the clipboard has the metadata of an object; select a Switch to paste it");
    }
    List<EnrichmentEdits.SwitchMetadata> switches = new ArrayList<>();
    List<EnrichmentEdits.SensorMetadata> sensors = new ArrayList<>();
    if (ofArea) {
      areas.forEach(
          area -> sensors.add(new EnrichmentEdits.SensorMetadata(area, copied.area().get())));
    } else {
      objects.forEach(
          object ->
              switches.add(
                  new EnrichmentEdits.SwitchMetadata(
                      object, fitted(copied.object(), object.choices().size()))));
    }
    int count = switches.size() + sensors.size();
    String onto =
        count > 1
            ? "%d %s".formatted(count, ofArea ? "areas" : "objects")
            : ofArea ? areas.get(0).name() : objects.get(0).object();
    return new EnrichmentEdits(enrichment).all("Paste Metadata to " + onto, switches, sensors);
  }

  /** Maps metadata to a number of versions. */
  private static List<ChoiceMetadata> fitted(List<ChoiceMetadata> from, int count) {
    if (from.size() == count) {
      return from;
    }
    List<ChoiceMetadata> fitted = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      fitted.add(ChoiceMetadata.NONE);
    }
    if (count == 0) {
      return fitted;
    }
    for (int i = 0; i < from.size(); i++) {
      ChoiceMetadata values = from.get(i);
      ConsistencyDegree degree =
          values.degree().orElse(VersionDegreeMapping.degree(i, from.size()));
      for (String schema : values.schemas()) {
        int version = VersionDegreeMapping.version(degree, fitted);
        fitted = new ArrayList<>(ObjectSchemaMatrix.put(fitted, schema, Optional.of(degree)));
        if (values.type().isPresent()) {
          fitted.set(version, fitted.get(version).with(values.type().get()));
        }
      }
    }
    return fitted;
  }

  private static Copied copied(String text) {
    List<String> lines = text.lines().toList();
    if (text.startsWith(AREA)) {
      List<List<String>> schemas = new ArrayList<>();
      for (String word : List.of("enter", "exit")) {
        schemas.add(
            lines.stream()
                .filter(line -> line.startsWith(word + TAB))
                .findFirst()
                .map(line -> MFStringParser.strings(line.substring(word.length() + 1)))
                .orElseThrow(MetadataClipboardFormat::incomplete));
      }
      return new Copied(List.of(), Optional.of(new SensorSchemas(schemas.get(0), schemas.get(1))));
    }
    List<ChoiceMetadata> values = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      List<String> fields = Arrays.asList(line.split(TAB, FIELDS));
      if (fields.size() < FIELDS) {
        throw incomplete();
      }
      values.add(
          new ChoiceMetadata(
              ConsistencyType.of(fields.get(0)),
              ConsistencyDegree.of(fields.get(1)),
              MFStringParser.strings(fields.get(2))));
    }
    return new Copied(values, Optional.empty());
  }

  private static EditRejectedException incomplete() {
    return new EditRejectedException(
        "the metadata in the clipboard is not complete; copy it again");
  }
}
