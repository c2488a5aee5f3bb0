package org.selectiverenderer.authoring.editing;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * Code completion for X3D XML: proposes elements that are allowed at the caret, missing attributes,
 * values of a field, and DEF names.
 */
public final class CodeCompletion {
  /** The statements allowed in elements that are not nodes (ISO/IEC 19776-1, 4.3). */
  private static final Map<String, List<String>> STATEMENTS =
      Map.of(
          "X3D", List.of("head", "Scene"),
          "head", List.of("component", "unit", "meta"),
          "Scene",
              List.of(
                  "ROUTE",
                  "ProtoDeclare",
                  "ExternProtoDeclare",
                  "ProtoInstance",
                  "IMPORT",
                  "EXPORT"),
          "ProtoDeclare", List.of("ProtoInterface", "ProtoBody"),
          "ProtoInterface", List.of("field"),
          "ProtoBody", List.of("ROUTE", "ProtoInstance"),
          "ExternProtoDeclare", List.of("field"),
          "ProtoInstance", List.of("fieldValue"),
          "IS", List.of("connect"));

  private static final Map<String, List<String>> ATTRIBUTES =
      Map.ofEntries(
          Map.entry("X3D", List.of("profile", "version")),
          Map.entry("component", List.of("name", "level")),
          Map.entry("unit", List.of("category", "name", "conversionFactor")),
          Map.entry("meta", List.of("name", "content")),
          Map.entry("ROUTE", List.of("fromNode", "fromField", "toNode", "toField")),
          Map.entry("ProtoDeclare", List.of("name", "appinfo", "documentation")),
          Map.entry("ExternProtoDeclare", List.of("name", "url", "appinfo", "documentation")),
          Map.entry("ProtoInstance", List.of("name", "DEF", "USE", "containerField")),
          Map.entry("field", List.of("name", "type", "accessType", "value", "appinfo")),
          Map.entry("fieldValue", List.of("name", "value")),
          Map.entry("connect", List.of("nodeField", "protoField")),
          Map.entry("IMPORT", List.of("inlineDEF", "importedDEF", "AS")),
          Map.entry("EXPORT", List.of("localDEF", "AS")));

  private final CharSequence text;
  private final NodeCatalogue catalogue;
  private final CaretContext place;
  private final int caret;

  /**
   * The proposals for a caret.
   *
   * @param from offset of the text that a proposal replaces, up to the caret
   * @param proposals first those that begin with the word at the caret, then those that contain it
   */
  public record Proposals(int from, List<CompletionProposal> proposals) {}

  private CodeCompletion(CharSequence text, int caret, NodeCatalogue catalogue) {
    this.text = text;
    this.caret = caret;
    this.catalogue = catalogue;
    this.place = CaretContext.at(text, caret);
  }

  /** Returns the proposals at an offset. */
  public static Proposals at(CharSequence text, int caret, NodeCatalogue catalogue) {
    return new CodeCompletion(text, caret, catalogue).proposals();
  }

  private Proposals proposals() {
    List<CompletionProposal> all =
        switch (place.kind()) {
          case CONTENT -> elements("<");
          case NAME -> elements("");
          case END -> endTag();
          case ATTRIBUTE -> attributes();
          case VALUE -> values();
          case NOTHING -> List.of();
        };
    int from = place.kind() == CaretContext.Kind.VALUE ? wordInValue() : place.from();
    String begun =
        text.subSequence(from, caret).toString().replace("\"", "").toLowerCase(Locale.ROOT);
    List<CompletionProposal> first = new ArrayList<>();
    List<CompletionProposal> second = new ArrayList<>();
    for (CompletionProposal each : all) {
      String word = each.word().toLowerCase(Locale.ROOT);
      if (word.contains(begun)) {
        (word.startsWith(begun) ? first : second).add(each);
      }
    }
    first.addAll(second);
    return new Proposals(from, first);
  }

  /**
   * Returns the start of the value at the caret: in a list only the present element, a string of an
   * MFString with its quotation marks.
   */
  private int wordInValue() {
    boolean list = field().map(FieldDefinition::type).filter(FieldType::multiple).isPresent();
    int from = caret;
    while (from > place.from() && (!list || text.charAt(from - 1) > ' ')) {
      from--;
    }
    return from;
  }

  private List<CompletionProposal> elements(String open) {
    NodeType parent = catalogue.find(place.element()).orElse(null);
    boolean known = parent != null || STATEMENTS.containsKey(place.element());
    Stream<String> statements =
        place.element().isEmpty()
            ? Stream.of("X3D")
            : STATEMENTS.getOrDefault(place.element(), List.of()).stream();
    Stream<NodeType> nodes =
        place.element().isEmpty()
            ? Stream.empty()
            : catalogue.all().stream().filter(type -> !known || fits(parent, type));
    return Stream.concat(
            nodes.map(type -> element(type.name(), open, type.component())),
            statements.map(name -> element(name, open, "")))
        .toList();
  }

  private boolean fits(@Nullable NodeType parent, NodeType child) {
    return switch (place.element()) {
      case "Scene", "ProtoBody" -> child.is("X3DChildNode") || place.element().equals("ProtoBody");
      default -> parent != null && !ContainerFieldRules.fitting(parent, child).isEmpty();
    };
  }

  private static CompletionProposal element(String name, String open, String about) {
    return new CompletionProposal(name, open + name, open.length() + name.length(), about);
  }

  private List<CompletionProposal> endTag() {
    String name = place.element();
    return name.isEmpty()
        ? List.of()
        : List.of(new CompletionProposal(name, name + ">", name.length() + 1, ""));
  }

  private List<CompletionProposal> attributes() {
    Optional<NodeType> type = catalogue.find(place.element());
    Stream<CompletionProposal> fields =
        type.stream()
            .flatMap(of -> of.fields().stream())
            .filter(field -> field.access().initialisable() && !field.type().isNode())
            .map(field -> attribute(field.name(), about(field)));
    Stream<String> others =
        type.isPresent()
            ? Stream.of("DEF", "USE", "containerField", "class")
            : ATTRIBUTES.getOrDefault(place.element(), List.of()).stream();
    return Stream.concat(fields, others.map(name -> attribute(name, "")))
        .filter(each -> !place.given().containsKey(each.word()))
        .toList();
  }

  private static String about(FieldDefinition field) {
    boolean told = !field.defaultText().isEmpty() && !field.defaultText().equals("NULL");
    return told ? field.type() + ", " + field.defaultText() : field.type().toString();
  }

  private CompletionProposal attribute(String name, String about) {
    char quote = QuoteDetector.near(text, caret);
    return new CompletionProposal(name, name + "=" + quote + quote, name.length() + 2, about);
  }

  private Optional<FieldDefinition> field() {
    return catalogue.find(place.element()).flatMap(type -> type.field(place.attribute()));
  }

  private List<CompletionProposal> values() {
    String attribute = place.attribute();
    if (attribute.equals("USE")) {
      return names(place.element());
    }
    if (place.element().equals("ROUTE")) {
      return routed(attribute);
    }
    if (attribute.equals("containerField")) {
      return catalogue.find(place.element()).stream()
          .map(type -> CompletionProposal.of(type.containerField(), ""))
          .toList();
    }
    return field().map(this::values).orElse(List.of());
  }

  private List<CompletionProposal> values(FieldDefinition field) {
    if (field.type().kind() == FieldType.Kind.BOOLEAN) {
      return Stream.of("true", "false").map(word -> CompletionProposal.of(word, "")).toList();
    }
    return field.values().stream().map(this::allowed).toList();
  }

  /**
   * Returns the proposal of an allowed value; the catalogue has strings of a list with their
   * quotation marks.
   */
  private CompletionProposal allowed(String value) {
    String written = place.quote() == '"' ? value.replace("\"", "&quot;") : value;
    return new CompletionProposal(value.replace("\"", ""), written, written.length(), "");
  }

  /** Returns the DEF names of elements of a type; all names for an empty type. */
  private List<CompletionProposal> names(String element) {
    return DefNameScanner.of(text, caret).entrySet().stream()
        .filter(each -> element.isEmpty() || each.getValue().equals(element))
        .map(each -> CompletionProposal.of(each.getKey(), each.getValue()))
        .toList();
  }

  private List<CompletionProposal> routed(String attribute) {
    boolean from = attribute.startsWith("from");
    if (attribute.endsWith("Node")) {
      return names("");
    }
    String node = place.given().getOrDefault(from ? "fromNode" : "toNode", "");
    String type = DefNameScanner.of(text, caret).getOrDefault(node, "");
    return catalogue.find(type).stream()
        .flatMap(of -> of.fields().stream())
        .filter(field -> from ? field.access().sendsEvents() : field.access().acceptsEvents())
        .map(field -> CompletionProposal.of(field.name(), field.type().toString()))
        .toList();
  }

  /** Detects the quote character that the author uses around attribute values. */
  private static final class QuoteDetector {
    private static final int FAR = 4096;

    private QuoteDetector() {}

    /**
     * Returns the quote character of the last attribute before an offset; {@code '} if there is
     * none nearby.
     */
    static char near(CharSequence text, int offset) {
      for (int i = offset - 2; i >= Math.max(0, offset - FAR); i--) {
        char next = text.charAt(i + 1);
        if (text.charAt(i) == '=' && (next == '"' || next == '\'')) {
          return next;
        }
      }
      return '\'';
    }
  }
}
