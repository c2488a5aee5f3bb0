package org.selectiverenderer.x3d;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLStreamException;

/** Says in plain words what the XML parser found wrong. */
final class XmlFaults {
  private static final Pattern ENTITY =
      Pattern.compile("ENTITY_REFERENCE \\(([^)]*)\\)|&([^;)]*);");
  private static final Pattern EXPECTED = Pattern.compile("expected </([^>]*)>");
  private static final Pattern PREFIX = Pattern.compile("prefix '([^']*)'");

  private XmlFaults() {}

  /** The fault as the first half of a sentence. */
  static String describe(XMLStreamException fault) {
    String raw = fault.getMessage() == null ? "" : fault.getMessage();
    String message = raw.toLowerCase(Locale.ROOT);
    if (message.contains("end-of-input") || message.contains("end of input")) {
      return "the file is cut off here";
    }
    if (message.contains("entity")) {
      Matcher entity = ENTITY.matcher(raw);
      return entity.find()
          ? "entities of a DOCTYPE are never expanded, and &"
              + (entity.group(1) != null ? entity.group(1) : entity.group(2))
              + "; is one"
          : "this is no valid reference to a character";
    }
    if (message.contains("unbound namespace prefix")) {
      Matcher prefix = PREFIX.matcher(raw);
      return "the prefix "
          + (prefix.find() ? prefix.group(1) : "here")
          + " is not declared by an xmlns attribute";
    }
    Matcher expected = EXPECTED.matcher(raw);
    if (expected.find()) {
      return "the XML is not well formed: </" + expected.group(1) + "> is expected here";
    }
    if (message.contains("duplicate attribute")) {
      return "the XML is not well formed: an attribute is given twice";
    }
    if (message.contains("second root element") || message.contains("epilog")) {
      return "the XML is not well formed: something follows the end of the root element";
    }
    if (message.contains("'<' not allowed") || message.contains("missing closing '>'")) {
      return "the XML is not well formed: '<' stands within a tag or its attribute";
    }
    return "the XML is not well formed here";
  }
}
