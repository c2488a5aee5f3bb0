package org.selectiverenderer.browser.nodes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * {@code docs/x3d-support.md} says what the code does with every node and field. Its tables are
 * written anew by {@code mvn test -Dtest=SupportPageTest -Dreports.update=true}. Which fields of
 * nodes that are acted on are only kept, and why, stands in {@code kept-fields.tsv}.
 */
class SupportPageTest {
  private static final Path PAGE = Path.of("docs/x3d-support.md");
  private static final Path KEPT =
      Path.of(
          "modules/browser/src/test/resources/org/selectiverenderer/browser/nodes/kept-fields.tsv");
  private static final String TABLES = "<!-- Below, all is written by SupportPageTest. -->\n";

  /** Fields of nearly every node, told once above the tables. */
  private static final Set<String> EVERYWHERE =
      Set.of(
          "metadata",
          "description",
          "bboxCenter",
          "bboxSize",
          "bboxDisplay",
          "visible",
          "children",
          "addChildren",
          "removeChildren");

  /** Fields whose names are put together: those of textures, of backs, of a Background's sides. */
  private static final Pattern COMPUTED =
      Pattern.compile("\\w+TextureMapping|back[A-Z]\\w+|\\w+Url");

  private static final Pattern LITERAL = Pattern.compile("\"([A-Za-z_0-9]+)\"");

  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final NodeFactory factory = new NodeFactory();

  /** Why a field is only kept, by {@code node field}. */
  private final Map<String, String> kept = new LinkedHashMap<>();

  SupportPageTest() throws IOException {
    for (String line : Files.readAllLines(KEPT, StandardCharsets.UTF_8)) {
      String[] cells = line.split("\t", -1);
      assertThat(cells).as(line).hasSize(3);
      assertThat(kept.put(cells[0] + " " + cells[1], cells[2])).as("twice: " + line).isNull();
    }
  }

  @Test
  void thePageSaysWhatTheCodeDoes() throws IOException {
    String page = Files.readString(PAGE).replace("\r\n", "\n");
    assertThat(page).contains(TABLES);
    String head = page.substring(0, page.indexOf(TABLES) + TABLES.length());
    if (Boolean.getBoolean("reports.update")) {
      page = head + tables();
      Files.writeString(PAGE, page);
    }
    assertThat(page).isEqualTo(head + tables());
  }

  @Test
  void fieldsThatAreOnlyKeptAreFieldsOfNodesThatAreActedOn() {
    assertThat(List.copyOf(kept.keySet()))
        .isSorted()
        .allSatisfy(
            name -> {
              NodeType type = catalogue.get(name.substring(0, name.indexOf(' ')));
              assertThat(type.field(name.substring(name.indexOf(' ') + 1))).as(name).isPresent();
              assertThat(factory.actsOn(type)).as("acted on: %s", type).isTrue();
            });
  }

  @Test
  void fieldsThatAreActedOnAreNamedSomewhereInTheCode() throws IOException {
    Set<String> named = new HashSet<>();
    for (String module : List.of("browser", "geometry", "render", "schema", "walkthrough", "x3d")) {
      try (Stream<Path> files = Files.walk(Path.of("modules", module, "src/main/java"))) {
        for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
          LITERAL.matcher(Files.readString(file)).results().forEach(r -> named.add(r.group(1)));
        }
      }
    }
    List<String> unnamed = new ArrayList<>();
    for (NodeType type : catalogue.all()) {
      for (FieldDefinition field : type.fields()) {
        // An input that is no field of its own is taken by what it sets.
        if (field.access() != AccessType.INPUT_ONLY
            && factory.actsOn(type)
            && isActedOn(type, field)
            && !named.contains(field.name())
            && !COMPUTED.matcher(field.name()).matches()) {
          unnamed.add(type + " " + field.name());
        }
      }
    }
    assertThat(unnamed).isEmpty();
  }

  private boolean isActedOn(NodeType type, FieldDefinition field) {
    return !EVERYWHERE.contains(field.name()) && !kept.containsKey(type + " " + field.name());
  }

  private String tables() {
    Map<String, List<NodeType>> components = new TreeMap<>();
    for (NodeType type : catalogue.all()) {
      components.computeIfAbsent(type.component(), name -> new ArrayList<>()).add(type);
    }
    StringBuilder page = new StringBuilder();
    components.forEach(
        (component, types) -> {
          page.append("\n## ").append(component).append("\n\n");
          page.append("| node | fields acted on | fields kept |\n| --- | --- | --- |\n");
          types.forEach(type -> page.append(row(type)));
        });
    return page.toString();
  }

  private String row(NodeType type) {
    if (!factory.actsOn(type)) {
      return "| %s | | all |\n".formatted(type);
    }
    List<String> acted = new ArrayList<>();
    List<String> only = new ArrayList<>();
    for (FieldDefinition field : type.fields()) {
      if (EVERYWHERE.contains(field.name())) {
        continue;
      }
      String why = kept.get(type + " " + field.name());
      if (why == null) {
        acted.add(field.name());
      } else {
        only.add(why.isEmpty() ? field.name() : field.name() + " (" + why + ")");
      }
    }
    return "| %s | %s | %s |\n"
        .formatted(
            type,
            acted.isEmpty() ? "it is acted on" : String.join(", ", acted),
            String.join(", ", only));
  }
}
