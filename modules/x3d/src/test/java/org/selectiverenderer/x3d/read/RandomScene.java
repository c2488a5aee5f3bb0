package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.XmlAttributeEscaper;

/**
 * A document of X3D XML, the same for the same seed, with nodes, values and statements of all
 * kinds, and now and then with faults.
 */
final class RandomScene {
  private static final String[] PIECES = {
    "a",
    "Tür",
    "日本",
    "\ud83d\ude80",
    "it's",
    "\"",
    "\\",
    "\\\\",
    "\\n",
    "&amp;",
    "<b>",
    "]]>",
    "#",
    "--",
    "{",
    "}",
    "[",
    "]",
    ",",
    " ",
    "  ",
    "\n",
    "\t",
    "%25",
    "%20",
    "NULL",
    "IS",
    "USE",
    "ecmascript:",
    "data:text/plain,",
    "\u00a0",
    "\u2028",
    "\u007f",
    "$",
    "0x",
    "-1",
    "true",
    "$$"
  };
  private static final String[] NUMBERS = {
    "0",
    "1",
    "-1",
    "+2",
    "007",
    "12",
    "0.5",
    ".5",
    "5.",
    "-.25",
    "1e3",
    "1E+05",
    "2.5e-3",
    "-0",
    "0.1000",
    "3.40282e38",
    "16777217"
  };
  private static final String[] WHOLE = {"0", "1", "-1", "+2", "007", "12", "0xFF", "2147483647"};
  private static final String[] NAMES = {
    "A", "B", "Seat", "Seat_2", "größe", "x-y", "_1", "Q", "T", "Name_of_a_long_thing", "children"
  };
  private static final String[] ODD_NAMES = {
    "a b", "1a", "x.y", "field", "IS", "Box", "a#b", "", "set_a b", "nan", "it's", "\"", "TRUE"
  };
  private static final String[] ACCESS = {
    "inputOutput", "initializeOnly", "inputOnly", "outputOnly"
  };

  private final Random random;
  private final NodeCatalogue catalogue;
  private final boolean faults;
  private final StringBuilder text = new StringBuilder();
  private final List<String> defined = new ArrayList<>();
  private final List<String> prototypes = new ArrayList<>();
  private final List<List<String[]>> interfaces = new ArrayList<>();
  private int left = 60;

  private RandomScene(long seed, NodeCatalogue catalogue) {
    random = new Random(seed);
    this.catalogue = catalogue;
    faults = seed % 3 == 0;
  }

  static String of(long seed, NodeCatalogue catalogue) {
    RandomScene scene = new RandomScene(seed, catalogue);
    scene.file();
    return scene.text.toString();
  }

  private boolean one(int in) {
    return random.nextInt(in) == 0;
  }

  private boolean fault() {
    return faults && one(25);
  }

  private String any(String... choices) {
    return choices[random.nextInt(choices.length)];
  }

  private String name() {
    return fault() ? any(ODD_NAMES) : any(NAMES);
  }

  private String string() {
    StringBuilder string = new StringBuilder();
    for (int i = random.nextInt(5); i > 0; i--) {
      string.append(any(PIECES));
    }
    return string.toString();
  }

  private void attribute(String name, String value) {
    if (!fault()) {
      text.append(' ').append(name).append("=\"");
      text.append(XmlAttributeEscaper.escaped(value, '"')).append('"');
    }
  }

  private void comment() {
    if (one(6)) {
      text.append("<!--").append(string().replace("--", "- -").replace('-', '_')).append("-->");
    }
  }

  private void file() {
    text.append("<?xml version='1.0' encoding='UTF-8'?>");
    comment();
    text.append("<X3D profile='Full' version='4.0'");
    if (fault()) {
      attribute("id", "x y");
    }
    text.append("><head>");
    for (int i = random.nextInt(4); i > 0; i--) {
      comment();
      text.append("<meta");
      attribute("name", string());
      attribute("content", string());
      text.append(one(20) ? " lang='de'/>" : "/>");
    }
    text.append("<component name='Core' level='1'/>");
    text.append(one(3) ? "<unit category='length' name='foot' conversionFactor='.3048'/>" : "");
    text.append("</head>");
    comment();
    text.append("<Scene>");
    for (int i = 1 + random.nextInt(5); i > 0; i--) {
      statement(0);
    }
    comment();
    text.append("</Scene></X3D>");
  }

  private void statement(int depth) {
    comment();
    switch (random.nextInt(9)) {
      case 0 -> prototype(depth);
      case 1 -> instance("");
      case 2 -> route();
      case 3 -> inline();
      case 4 -> external();
      case 5 -> script();
      default -> node(child("X3DChildNode"), depth, "");
    }
  }

  private NodeType child(String kind) {
    List<NodeType> all =
        catalogue.names().stream()
            .map(name -> catalogue.find(name).orElseThrow())
            .filter(type -> type.is(kind))
            .toList();
    return all.get(random.nextInt(all.size()));
  }

  private void def() {
    if (one(3)) {
      String name = name() + (faults ? "" : defined.size());
      attribute("DEF", name);
      defined.add(name);
    }
  }

  private void node(NodeType type, int depth, String container) {
    left--;
    text.append("<").append(type.name());
    if (!defined.isEmpty() && fault()) {
      attribute("USE", defined.get(random.nextInt(defined.size())));
      text.append("/>");
      return;
    }
    def();
    if (!container.isEmpty() && !fault()) {
      attribute("containerField", container);
    }
    for (FieldDefinition field : type.fields()) {
      if (!field.type().isNode() && field.access().initialisable() && one(3)) {
        if (!field.name().equals("sourceCode")) {
          attribute(field.name(), value(field.type()));
        }
      }
    }
    text.append('>');
    for (FieldDefinition field : type.fields()) {
      if (field.type().isNode() && field.access().initialisable() && depth < 5 && left > 0) {
        for (int i = field.type().multiple() ? random.nextInt(3) : random.nextInt(2); i > 0; i--) {
          comment();
          within(field, depth);
        }
      }
    }
    if (one(10)) {
      route();
    }
    comment();
    text.append("</").append(type.name()).append('>');
  }

  private void within(FieldDefinition field, int depth) {
    List<NodeType> fitting =
        catalogue.names().stream()
            .map(name -> catalogue.find(name).orElseThrow())
            .filter(child -> ContainerFieldRules.accepts(field, child))
            .toList();
    if (!fitting.isEmpty() && !field.name().equals("field")) {
      node(fitting.get(random.nextInt(fitting.size())), depth + 1, field.name());
    }
  }

  private void route() {
    text.append("<ROUTE");
    attribute("fromNode", defined.isEmpty() ? name() : defined.get(0));
    attribute("fromField", name());
    attribute("toNode", defined.isEmpty() ? name() : defined.get(defined.size() - 1));
    attribute("toField", fault() ? string() : "set_" + name());
    text.append("/>");
  }

  private void inline() {
    String name = "In" + defined.size();
    defined.add(name);
    text.append("<Inline DEF='").append(name).append("' url='\"a.x3d\"'/><IMPORT");
    attribute("inlineDEF", name);
    attribute("importedDEF", name());
    attribute("AS", name() + "As" + defined.size());
    text.append("/><EXPORT");
    attribute("localDEF", name);
    attribute("AS", name() + defined.size());
    text.append("/>");
  }

  private FieldType type() {
    return FieldType.values()[random.nextInt(FieldType.values().length)];
  }

  /** Writes the declaration of a field and returns its name, type and access. */
  private String[] field(int number, boolean valued) {
    FieldType type = type();
    String name = name() + number;
    String access = any(ACCESS);
    text.append("<field");
    attribute("name", name);
    attribute("type", fault() ? any("SFFoo", "", " SFBool") : type.name());
    attribute("accessType", fault() ? "exposedField" : access);
    if (one(30)) {
      attribute("appinfo", string());
    }
    boolean initial = access.startsWith("in") && !access.equals("inputOnly");
    if (valued && initial && !type.isNode()) {
      attribute("value", value(type));
    } else if (fault()) {
      attribute("value", any("null", "NULL", "1"));
    }
    text.append('>');
    comment();
    if (valued && initial && type.isNode()) {
      nodes(type);
    }
    text.append("</field>");
    return new String[] {name, type.name(), access};
  }

  private void nodes(FieldType type) {
    for (int i = random.nextInt(type.multiple() || fault() ? 3 : 2); i > 0; i--) {
      node(child("X3DChildNode"), 4, "");
    }
  }

  private void prototype(int depth) {
    if (depth > 1) {
      return;
    }
    String name = "P" + name() + prototypes.size();
    List<String> outer = List.copyOf(defined);
    defined.clear();
    text.append("<ProtoDeclare");
    attribute("name", name);
    if (one(8)) {
      attribute("documentation", string());
    }
    text.append("><ProtoInterface>");
    List<String[]> fields = new ArrayList<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      comment();
      fields.add(field(i, true));
    }
    comment();
    text.append("</ProtoInterface><ProtoBody><Group DEF='Root'>");
    comment();
    for (int i = random.nextInt(3); i > 0; i--) {
      statement(depth + 1);
    }
    connected(fields);
    text.append("</Group>");
    route();
    text.append("</ProtoBody></ProtoDeclare>");
    prototypes.add(name);
    interfaces.add(fields);
    defined.clear();
    defined.addAll(outer);
  }

  /** Writes a Script whose fields are those of the prototype. */
  private void connected(List<String[]> fields) {
    text.append("<Script>");
    for (String[] field : fields) {
      text.append("<field");
      attribute("name", field[0]);
      attribute("type", field[1]);
      attribute("accessType", field[2]);
      text.append("/>");
    }
    text.append("<IS>");
    for (String[] field : fields) {
      comment();
      text.append("<connect");
      attribute("nodeField", field[0]);
      attribute("protoField", field[0]);
      text.append("/>");
    }
    text.append("</IS></Script>");
  }

  private void instance(String container) {
    if (prototypes.isEmpty() && !faults) {
      return;
    }
    int which = prototypes.isEmpty() ? -1 : random.nextInt(prototypes.size());
    text.append("<ProtoInstance");
    attribute("name", which < 0 ? name() : prototypes.get(which));
    def();
    if (!container.isEmpty()) {
      attribute("containerField", container);
    }
    text.append('>');
    for (String[] field : which < 0 ? List.<String[]>of() : interfaces.get(which)) {
      if (field[2].startsWith("in") && !field[2].equals("inputOnly") && one(2)) {
        comment();
        text.append("<fieldValue");
        attribute("name", fault() ? name() : field[0]);
        FieldType type = FieldType.valueOf(field[1]);
        if (!type.isNode()) {
          attribute("value", value(type));
        } else if (fault()) {
          attribute("value", "null");
        }
        text.append('>');
        if (type.isNode()) {
          nodes(type);
        }
        text.append("</fieldValue>");
      }
    }
    text.append("</ProtoInstance>");
  }

  private void external() {
    text.append("<ExternProtoDeclare");
    attribute("name", "E" + name());
    attribute("url", value(FieldType.MFString));
    if (one(8)) {
      attribute("appinfo", string());
    }
    text.append('>');
    for (int i = random.nextInt(3); i > 0; i--) {
      comment();
      field(i, false);
    }
    text.append("</ExternProtoDeclare>");
  }

  private void script() {
    text.append("<Script");
    def();
    if (one(2)) {
      attribute("url", value(FieldType.MFString));
    }
    text.append('>');
    for (int i = random.nextInt(4); i > 0; i--) {
      comment();
      field(i, true);
    }
    if (one(2)) {
      String code = any("", "ecmascript:\n", "javascript: ") + "// " + string() + "\nvar a = 1;";
      text.append("<![CDATA[").append(code.replace("]]>", "]] >")).append("]]>");
    }
    text.append("</Script>");
  }

  private String value(FieldType type) {
    if (fault()) {
      return any("", "NaN", "1 2 nonsense", "INF", "\"", "a \"b", "null", "1,,2");
    }
    int count = type.multiple() ? random.nextInt(3) : 1;
    StringBuilder value = new StringBuilder();
    for (int i = 0; i < count; i++) {
      if (type.kind() == FieldType.Kind.STRING) {
        String string = string();
        value.append(type.multiple() ? FieldTokenizer.string(string) + any(" ", ", ") : string);
      } else if (type.components() == 0) {
        value.append("1 2 1 0xFF ").append(any(WHOLE)).append(' ');
      } else {
        for (int j = 0; j < type.components(); j++) {
          value.append(i + j == 0 ? "" : any(" ", " ", ", ", "\n ", "  "));
          value.append(
              switch (type.kind()) {
                case BOOLEAN -> any("true", "false");
                case INT -> any(WHOLE);
                default -> any(NUMBERS);
              });
        }
      }
    }
    return value.toString();
  }
}
