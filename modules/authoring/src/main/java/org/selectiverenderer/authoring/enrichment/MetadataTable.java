package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SchemaField.Owner;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DecodedText;

/**
 * Reads schema metadata from a table with the columns {@code node,choice,field,value}: {@code node}
 * is a DEF name, {@code choice} the index of a Switch's child from 0, empty for a sensor. Several
 * rows of one field are several values. Existing values of a field in the table are replaced, all
 * other metadata stays; an empty value clears the field.
 */
public final class MetadataTable {
  private static final List<String> COLUMNS = List.of("node", "choice", "field", "value");
  private static final CsvColumnSpec FORM = new CsvColumnSpec(COLUMNS, true, true);

  private final DocumentEnrichment enrichment;
  private final CsvErrorHandler faults;
  private final Map<String, EnrichedSwitch> switches;
  private final Map<String, EnrichedSensor> sensors;
  private final Map<String, Map<Integer, Map<SchemaField, List<String>>>> ofSwitches =
      new LinkedHashMap<>();
  private final Map<String, Map<SchemaField, List<String>>> ofSensors = new LinkedHashMap<>();

  private MetadataTable(DocumentEnrichment enrichment, CsvErrorHandler faults) {
    this.enrichment = enrichment;
    this.faults = faults;
    this.switches = enrichment.switchesByName();
    this.sensors = enrichment.sensorsByName();
  }

  /**
   * Creates the edit of a table.
   *
   * @param name name of the file, for messages
   * @return empty if a row is invalid, which is reported to {@code problems}: all rows are applied
   *     or none
   */
  public static Optional<Edit> edit(
      DocumentEnrichment enrichment, String name, byte[] table, ProblemCollector problems) {
    ProblemCollector own = new ProblemCollector(problems::add);
    CsvErrorHandler faults = (at, message) -> own.error(at, message + "; the table is not applied");
    Optional<CsvTable> read =
        CsvTable.parse(name, DecodedText.of(table).characters(), FORM, faults);
    if (read.isEmpty() || !read.get().require(COLUMNS, String.join(",", COLUMNS))) {
      return Optional.empty();
    }
    MetadataTable wanted = new MetadataTable(enrichment, faults);
    read.get().rows().forEach(wanted::add);
    return own.any() ? Optional.empty() : Optional.of(wanted.edit("Apply " + name));
  }

  private void add(CsvRow row) {
    Optional<SchemaField> field = SchemaField.of(row.cell("field"));
    if (field.isEmpty()) {
      error(row, "field", "schema metadata has no field '%s'".formatted(row.cell("field")));
      return;
    }
    String node = row.cell("node");
    Owner owner = field.get().owner();
    if (owner == Owner.CHOICE ? !switches.containsKey(node) : !sensors.containsKey(node)) {
      Set<String> known = owner == Owner.CHOICE ? switches.keySet() : sensors.keySet();
      error(
          row,
          "node",
          "there is no %s '%s' in the scene%s"
              .formatted(
                  owner == Owner.CHOICE ? "Switch" : "ProximitySensor",
                  node,
                  SpellingSuggester.nearest(node, known)
                      .map(near -> "; is " + near + " meant?")
                      .orElse("")));
      return;
    }
    if (owner == Owner.SENSOR) {
      if (!row.cell("choice").isEmpty()) {
        error(row, "choice", "a ProximitySensor has no choices; leave the column choice empty");
      }
      add(
          ofSensors.computeIfAbsent(node, key -> new EnumMap<>(SchemaField.class)),
          field.get(),
          row);
      return;
    }
    choice(row, switches.get(node))
        .ifPresent(
            index ->
                add(
                    ofSwitches
                        .computeIfAbsent(node, key -> new LinkedHashMap<>())
                        .computeIfAbsent(index, key -> new EnumMap<>(SchemaField.class)),
                    field.get(),
                    row));
  }

  private Optional<Integer> choice(CsvRow row, EnrichedSwitch node) {
    int choices = node.choices().size();
    try {
      int index = Integer.parseInt(row.cell("choice"));
      if (index >= 0 && index < choices) {
        return Optional.of(index);
      }
    } catch (NumberFormatException e) {
      // reported below, with the valid range
    }
    error(
        row,
        "choice",
        "%s has choices 0 to %d, not '%s'".formatted(node.name(), choices - 1, row.cell("choice")));
    return Optional.empty();
  }

  private void add(Map<SchemaField, List<String>> fields, SchemaField field, CsvRow row) {
    List<String> values = fields.computeIfAbsent(field, key -> new ArrayList<>());
    String value =
        field == SchemaField.DEGREE_OF_CONSISTENCY ? row.decimal("value") : row.cell("value");
    if (value.isEmpty()) {
      return;
    }
    boolean single =
        field == SchemaField.CONSISTENCY_TYPE || field == SchemaField.DEGREE_OF_CONSISTENCY;
    if (single && !values.isEmpty()) {
      error(row, "value", "%s already has the value %s".formatted(field.spelling(), values.get(0)));
    } else if (field == SchemaField.CONSISTENCY_TYPE && ConsistencyType.of(value).isEmpty()) {
      error(
          row,
          "value",
          "'%s' is unknown; write consistent, inconsistent or frame".formatted(value));
    } else if (field == SchemaField.DEGREE_OF_CONSISTENCY
        && ConsistencyDegree.of(value).isEmpty()) {
      error(
          row,
          "value",
          "'%s' is not a degree; write low, high or a number from 0 to 1".formatted(value));
    } else if (!single && SchemaNameValidator.complaint(value).isPresent()) {
      error(row, "value", SchemaNameValidator.complaint(value).orElseThrow());
    } else {
      values.add(value);
    }
  }

  private void error(CsvRow row, String column, String message) {
    faults.fault(row.location(column), message);
  }

  private Edit edit(String name) {
    List<EnrichmentEdits.SwitchMetadata> wishes = new ArrayList<>();
    ofSwitches.forEach(
        (def, byChoice) -> {
          EnrichedSwitch node = switches.get(def);
          List<ChoiceMetadata> values = new ArrayList<>(node.values());
          byChoice.forEach((index, fields) -> values.set(index, merged(values.get(index), fields)));
          wishes.add(new EnrichmentEdits.SwitchMetadata(node, values));
        });
    List<EnrichmentEdits.SensorMetadata> areas = new ArrayList<>();
    ofSensors.forEach(
        (def, fields) -> {
          EnrichedSensor node = sensors.get(def);
          SensorSchemas before = node.schemas();
          areas.add(
              new EnrichmentEdits.SensorMetadata(
                  node,
                  new SensorSchemas(
                      distinct(fields.getOrDefault(SchemaField.ENTER_TIME_SCHEMA, before.enter())),
                      distinct(fields.getOrDefault(SchemaField.EXIT_TIME_SCHEMA, before.exit())))));
        });
    return new EnrichmentEdits(enrichment).all(name, wishes, areas);
  }

  private static List<String> distinct(List<String> values) {
    return values.stream().distinct().toList();
  }

  private static ChoiceMetadata merged(
      ChoiceMetadata before, Map<SchemaField, List<String>> fields) {
    List<String> type = fields.get(SchemaField.CONSISTENCY_TYPE);
    List<String> degree = fields.get(SchemaField.DEGREE_OF_CONSISTENCY);
    return new ChoiceMetadata(
        type == null ? before.type() : type.stream().findFirst().flatMap(ConsistencyType::of),
        degree == null
            ? before.degree()
            : degree.stream().findFirst().flatMap(ConsistencyDegree::of),
        fields.getOrDefault(SchemaField.SCHEMA_BELONGINESS, before.schemas()));
  }
}
