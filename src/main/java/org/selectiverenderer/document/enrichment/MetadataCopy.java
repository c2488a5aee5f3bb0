package org.selectiverenderer.document.enrichment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.XmlValues;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.write.ValueText;

/**
 * Converts the metadata of an object or an area to a clipboard text, and such a text to an edit.
 * Each line describes one version, or the entry or exit of an area: fields separated by tabs,
 * schemas as in an MFString.
 */
public final class MetadataCopy {
  private static final String OBJECT = "object metadata";
  private static final String AREA = "area metadata";
  private static final String TAB = "\t";
  private static final int FIELDS = 3;

  /** The parsed content of a text. */
  private record Copied(List<ChoiceValues> object, Optional<SensorSchemas> area) {}

  private MetadataCopy() {}

  /** Returns the text of an object's metadata. */
  public static String of(EnrichedSwitch node) {
    StringBuilder text = new StringBuilder(OBJECT).append(TAB).append(node.object()).append('\n');
    for (ChoiceValues values : node.values()) {
      text.append(values.type().map(ConsistencyType::spelling).orElse(""))
          .append(TAB)
          .append(values.degree().map(Degree::spelling).orElse(""))
          .append(TAB)
          .append(ValueText.strings(values.schemas()))
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
        + ValueText.strings(node.schemas().enter())
        + "\nexit\t"
        + ValueText.strings(node.schemas().exit())
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
   * @throws EditRefused with a sentence, if the text is not metadata, or of the other kind
   */
  public static Edit paste(
      Enrichment enrichment,
      String text,
      List<EnrichedSwitch> objects,
      List<EnrichedSensor> areas) {
    if (!recognises(text)) {
      throw new EditRefused(
          "the clipboard contains no metadata; choose an object or an area and copy its metadata"
              + " first");
    }
    Copied copied = copied(text);
    boolean ofArea = copied.area().isPresent();
    if (ofArea ? areas.isEmpty() : objects.isEmpty()) {
      throw new EditRefused(
          ofArea
              ? "the clipboard has the metadata of an area; select a ProximitySensor to paste it"
              : "the clipboard has the metadata of an object; select a Switch to paste it");
    }
    List<EnrichmentEdits.SwitchWish> switches = new ArrayList<>();
    List<EnrichmentEdits.SensorWish> sensors = new ArrayList<>();
    if (ofArea) {
      areas.forEach(area -> sensors.add(new EnrichmentEdits.SensorWish(area, copied.area().get())));
    } else {
      objects.forEach(
          object ->
              switches.add(
                  new EnrichmentEdits.SwitchWish(
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
  private static List<ChoiceValues> fitted(List<ChoiceValues> from, int count) {
    if (from.size() == count) {
      return from;
    }
    List<ChoiceValues> fitted = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      fitted.add(ChoiceValues.NONE);
    }
    if (count == 0) {
      return fitted;
    }
    for (int i = 0; i < from.size(); i++) {
      ChoiceValues values = from.get(i);
      Degree degree = values.degree().orElse(VersionLadder.degree(i, from.size()));
      for (String schema : values.schemas()) {
        int version = VersionLadder.version(degree, fitted);
        fitted = new ArrayList<>(SchemaOverview.put(fitted, schema, Optional.of(degree)));
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
                .map(line -> XmlValues.strings(line.substring(word.length() + 1)))
                .orElseThrow(MetadataCopy::incomplete));
      }
      return new Copied(List.of(), Optional.of(new SensorSchemas(schemas.get(0), schemas.get(1))));
    }
    List<ChoiceValues> values = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      List<String> fields = Arrays.asList(line.split(TAB, FIELDS));
      if (fields.size() < FIELDS) {
        throw incomplete();
      }
      values.add(
          new ChoiceValues(
              ConsistencyType.of(fields.get(0)),
              Degree.of(fields.get(1)),
              XmlValues.strings(fields.get(2))));
    }
    return new Copied(values, Optional.empty());
  }

  private static EditRefused incomplete() {
    return new EditRefused("the metadata in the clipboard is not complete; copy it again");
  }
}
