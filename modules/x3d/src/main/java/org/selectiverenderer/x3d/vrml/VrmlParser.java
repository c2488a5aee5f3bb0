package org.selectiverenderer.x3d.vrml;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.ValueCommentStripper;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Parses a file: its header line, its head statements, and its scene. */
public final class VrmlParser implements ElementTreeBuilder.Parser {
  private static final Pattern VERSION = Pattern.compile("#(?:X3D|VRML)\\s+V?(\\d+\\.\\d+).*");

  /**
   * The X3D profile that corresponds to VRML97; the version below still has all nodes of VRML97.
   */
  private static final String VRML97_PROFILE = "Immersive";

  private static final String VRML97_VERSION = "3.3";

  private final NodeCatalogue catalogue;
  private final SceneEncoding encoding;

  /** Creates a parser of one encoding for the node types of a catalogue. */
  public VrmlParser(NodeCatalogue catalogue, SceneEncoding encoding) {
    this.catalogue = catalogue;
    this.encoding = encoding;
  }

  @Override
  public ValueCommentStripper cleaner() {
    return VrmlScanner::clean;
  }

  @Override
  public void parse(ElementTreeBuilder document) throws XmlParseException {
    VrmlScanner scanner = new VrmlScanner(document);
    while (scanner.peek() != '#') {
      scanner.step(); // white space, which the detection of the encoding skips
    }
    int start = scanner.at();
    String line = scanner.line();
    document.open("X3D", null, null, start, scanner.at());
    version(document, line, start);
    head(document, scanner);
    int body = Math.max(start + 1, scanner.at());
    document.open("Scene", null, null, body - 1, body - 1);
    VrmlScope scope = VrmlScope.ofScene(encoding == SceneEncoding.VRML97);
    NodeParser nodes = new NodeParser(document, scanner, catalogue);
    scanner.space();
    while (!scanner.ended()) {
      nodes.statement(scope, NodeParser.TOP);
      scanner.space();
    }
    document.close(scanner.at());
    document.close(scanner.at());
  }

  private void version(ElementTreeBuilder document, String line, int start) {
    Matcher version = VERSION.matcher(line);
    if (encoding == SceneEncoding.VRML97) {
      document.attribute("profile", VRML97_PROFILE, start);
      document.attribute("version", VRML97_VERSION, start);
    } else if (version.matches()) {
      int from = start + version.start(1);
      document.attribute("version", version.group(1), from, from, start + version.end(1));
    }
  }

  /** Parses the statements before the scene (ISO/IEC 19776-2, 4.3.3). */
  private void head(ElementTreeBuilder document, VrmlScanner scanner) throws XmlParseException {
    boolean head = false;
    while (true) {
      String next = scanner.nextWord();
      String element =
          switch (next) {
            case "PROFILE" -> "";
            case "COMPONENT" -> "component";
            case "META" -> "meta";
            case "UNIT" -> "unit";
            default -> null;
          };
      if (element == null) {
        break;
      }
      int start = scanner.space();
      scanner.passWord();
      if (element.isEmpty()) {
        profile(document, scanner, start, head);
        continue;
      }
      if (!head) {
        document.open("head", null, null, start - 1, start - 1);
        head = true;
      }
      document.open(element, null, null, start, scanner.at());
      switch (element) {
        case "component" -> component(document, scanner);
        case "meta" -> {
          quoted(document, scanner, "name");
          quoted(document, scanner, "content");
        }
        default -> {
          word(document, scanner, "category");
          word(document, scanner, "name");
          word(document, scanner, "conversionFactor");
        }
      }
      document.close(scanner.at());
    }
    if (head) {
      document.close(scanner.at());
    }
  }

  private static void profile(
      ElementTreeBuilder document, VrmlScanner scanner, int start, boolean head)
      throws XmlParseException {
    if (head) {
      throw document.fault(start, "PROFILE must stand before COMPONENT, META and UNIT");
    }
    int from = scanner.space();
    String profile = scanner.name("the name of a profile");
    document.attribute("profile", profile, start, from, scanner.at());
  }

  private static void component(ElementTreeBuilder document, VrmlScanner scanner)
      throws XmlParseException {
    int from = scanner.space();
    String name = scanner.word(':');
    document.attribute("name", name, from, from, scanner.at());
    if (scanner.nextWord().startsWith(":")) {
      scanner.space();
      scanner.step();
      word(document, scanner, "level");
    }
  }

  private static void word(ElementTreeBuilder document, VrmlScanner scanner, String attribute)
      throws XmlParseException {
    int from = scanner.space();
    String word = scanner.name("a word");
    document.attribute(attribute, word, from, from, scanner.at());
  }

  private static void quoted(ElementTreeBuilder document, VrmlScanner scanner, String attribute)
      throws XmlParseException {
    int from = scanner.space();
    String words = scanner.string("a string in double quotes");
    document.attribute(attribute, words, from, from + 1, scanner.at() - 1);
  }
}
