package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.schema.SchemaUsage;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * The schema metadata of the Switches and ProximitySensors of a document. It is always up to date;
 * nodes that no edit has touched are not read again. It belongs to the thread of the document.
 */
public final class DocumentEnrichment {
  private record Read(long revision, boolean shared, Object node) {}

  private final SceneDocument document;
  private final NodeCatalogue catalogue;
  private final EnrichedNodeReader reading;
  private final Map<DocumentElement, Read> read = new IdentityHashMap<>();
  private List<DocumentElement> switches = List.of();
  private List<DocumentElement> sensors = List.of();
  private long listed = -1;
  private @Nullable List<EnrichedSwitch> switchNodes;
  private @Nullable List<EnrichedSensor> sensorNodes;
  private @Nullable SchemaUsage<DocumentElement> use;
  private @Nullable SchemaUsage<DocumentElement> judged;
  private Map<String, ElementFinding> schemaFindings = Map.of();
  private @Nullable List<ElementFinding> findings;

  public DocumentEnrichment(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
    this.reading = new EnrichedNodeReader(document, catalogue);
  }

  public SceneDocument document() {
    return document;
  }

  /**
   * Returns all Switches in document order, including those in prototypes; none while the text is
   * not well-formed.
   */
  public List<EnrichedSwitch> switches() {
    list();
    if (switchNodes == null) {
      List<EnrichedSwitch> nodes = new ArrayList<>(switches.size());
      for (int i = 0; i < switches.size(); i++) {
        nodes.add(switchNode(switches.get(i), i));
      }
      switchNodes = Collections.unmodifiableList(nodes);
    }
    return switchNodes;
  }

  /** Returns all ProximitySensors in document order, likewise. */
  public List<EnrichedSensor> sensors() {
    list();
    if (sensorNodes == null) {
      List<EnrichedSensor> nodes = new ArrayList<>(sensors.size());
      for (int i = 0; i < sensors.size(); i++) {
        nodes.add(sensorNode(sensors.get(i), i));
      }
      sensorNodes = Collections.unmodifiableList(nodes);
    }
    return sensorNodes;
  }

  /** Returns the Switch of an element; empty for other elements. */
  public Optional<EnrichedSwitch> switchNode(DocumentElement element) {
    list();
    int index = element.attached() ? indexOf(switches, element) : -1;
    return index < 0 ? Optional.empty() : Optional.of(switchNode(element, index));
  }

  /** Returns the ProximitySensor of an element; empty for other elements. */
  public Optional<EnrichedSensor> sensorNode(DocumentElement element) {
    list();
    int index = element.attached() ? indexOf(sensors, element) : -1;
    return index < 0 ? Optional.empty() : Optional.of(sensorNode(element, index));
  }

  private static int indexOf(List<DocumentElement> elements, DocumentElement element) {
    int low = 0;
    int high = elements.size() - 1;
    while (low <= high) {
      int middle = (low + high) >>> 1;
      DocumentElement found = elements.get(middle);
      if (found == element) {
        return middle;
      }
      if (found.start() < element.start()) {
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    return -1;
  }

  /** Returns the Switches by name; the first one of equal names. */
  public Map<String, EnrichedSwitch> switchesByName() {
    Map<String, EnrichedSwitch> named = new HashMap<>();
    switches().forEach(node -> named.putIfAbsent(node.name(), node));
    return named;
  }

  /** Returns the ProximitySensors by name; the first one of equal names. */
  public Map<String, EnrichedSensor> sensorsByName() {
    Map<String, EnrichedSensor> named = new HashMap<>();
    sensors().forEach(node -> named.putIfAbsent(node.name(), node));
    return named;
  }

  private void use(SchemaUsage<DocumentElement> found, EnrichedSwitch node, EnrichedField field) {
    List<String> present =
        new QualityTargets(document, catalogue).present(node.element(), field.target());
    for (EnrichedField.Level level : field.levels()) {
      found.choice(node.element(), level.metadata().schemas(), level.values().equals(present));
    }
  }

  /** Returns which schemas are activated by areas and which contain objects. */
  public SchemaUsage<DocumentElement> use() {
    list();
    if (use == null) {
      SchemaUsage<DocumentElement> found = new SchemaUsage<>();
      sensors().forEach(sensor -> found.area(sensor.element(), sensor.schemas()));
      for (EnrichedSwitch node : switches()) {
        for (EnrichedSwitch.ChoiceNode choice : node.choices()) {
          found.choice(
              node.element(), choice.values().schemas(), choice.index() == node.whichChoice());
        }
        node.fields().forEach(field -> use(found, node, field));
      }
      use = found;
    }
    return use;
  }

  /** Returns all schema names in alphabetical order, which forms propose. */
  public List<String> schemas() {
    TreeSet<String> all = new TreeSet<>(use().known());
    all.addAll(use().activated());
    return List.copyOf(all);
  }

  /** Returns the findings about the metadata in document order. */
  public List<ElementFinding> findings() {
    list();
    if (findings == null) {
      List<ElementFinding> found = new ArrayList<>();
      switches().forEach(node -> found.addAll(node.findings()));
      sensors().forEach(node -> found.addAll(node.findings()));
      found.addAll(schemaFindings().values());
      found.sort(Comparator.comparingInt(finding -> finding.element().start()));
      findings = Collections.unmodifiableList(found);
    }
    return findings;
  }

  /** Returns the findings about schemas, by schema: those without an area or without an object. */
  public Map<String, ElementFinding> schemaFindings() {
    SchemaUsage<DocumentElement> now = use();
    if (judged == null || judged != now && !judged.sameAs(now)) {
      Map<String, ElementFinding> found = new LinkedHashMap<>();
      now.unmatched()
          .forEach(unmatched -> found.putIfAbsent(unmatched.schema(), finding(unmatched)));
      schemaFindings = Collections.unmodifiableMap(found);
    }
    judged = now;
    return schemaFindings;
  }

  private ElementFinding finding(SchemaUsage.Unmatched<DocumentElement> unmatched) {
    String schema = unmatched.schema();
    return new ElementFinding(
        unmatched.node(),
        Problem.Severity.WARNING, // as the validator says of the same
        unmatched.message(),
        unmatched
            .meant()
            .map(
                meant ->
                    new ElementFinding.Fix(
                        "Rename " + schema + " to " + meant,
                        () -> new EnrichmentEdits(this).renameSchema(schema, meant))));
  }

  private EnrichedSwitch switchNode(DocumentElement element, int index) {
    return (EnrichedSwitch) known(element, each -> reading.switchNode(each, index));
  }

  private EnrichedSensor sensorNode(DocumentElement element, int index) {
    return (EnrichedSensor) known(element, each -> reading.sensorNode(each, index));
  }

  private Object known(DocumentElement element, Function<DocumentElement, Object> reader) {
    Read before = read.get(element);
    boolean current =
        before != null
            && (before.shared()
                ? before.revision() == document.revision()
                : before.revision() >= element.changed());
    if (before != null && current) {
      return before.node();
    }
    Object node = reader.apply(element);
    read.put(element, new Read(document.revision(), reading.shares(element), node));
    return node;
  }

  /** Lists the nodes again if the document has changed. */
  private void list() {
    if (listed == document.revision()) {
      return;
    }
    listed = document.revision();
    use = null;
    switchNodes = null;
    sensorNodes = null;
    findings = null;
    List<DocumentElement> foundSwitches =
        document.tree().map(ElementTree::switches).orElse(List.of());
    List<DocumentElement> foundSensors =
        document.tree().map(ElementTree::sensors).orElse(List.of());
    boolean same = foundSwitches == switches && foundSensors == sensors;
    switches = foundSwitches;
    sensors = foundSensors;
    if (!same) {
      read.keySet().removeIf(element -> !element.attached() || element.def().isEmpty());
    }
  }
}
