package org.selectiverenderer.x3d.json;

import com.fasterxml.jackson.core.JsonToken;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.ValueCommentStripper;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Parses a scene in the JSON encoding to nested elements. */
public final class X3dJsonParser implements ElementTreeBuilder.Parser {
  private final NodeCatalogue catalogue;

  /** Creates a parser for the node types of a catalogue. */
  public X3dJsonParser(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Flattens arrays of arrays of numbers, which some programs write. */
  @Override
  public ValueCommentStripper cleaner() {
    return (value, length) -> {
      for (int i = 0; i < length; i++) {
        if (value[i] == '[' || value[i] == ']') {
          value[i] = ' ';
        }
      }
    };
  }

  @Override
  public void parse(ElementTreeBuilder document) throws XmlParseException {
    try (JsonTokenReader tokens = new JsonTokenReader(document)) {
      new Reading(document, tokens, catalogue).file();
    }
  }

  /** The parsing of one file. */
  private record Reading(
      ElementTreeBuilder document, JsonTokenReader tokens, NodeCatalogue catalogue) {
    void file() throws XmlParseException {
      tokens.next();
      boolean found = false;
      while (tokens.next() == JsonToken.FIELD_NAME) {
        String name = tokens.text();
        int at = tokens.start();
        JsonToken value = tokens.next();
        if (name.equals("X3D") && value == JsonToken.START_OBJECT && !found) {
          element(name, at, "");
          found = true;
        } else if (name.equals("#comment")) {
          document.comment(String.join("\n", strings()), at);
        } else {
          tokens.skip();
        }
      }
      if (!found) {
        throw document.fault(
            0, "this is JSON, but not a scene, which needs an object with a member \"X3D\"");
      }
      tokens.end();
    }

    /**
     * Reads the element of the object at the current token.
     *
     * @param at the offset of the element's name
     * @param field the field of the parent that contains it; empty if unspecified
     */
    private void element(String name, int at, String field) throws XmlParseException {
      document.open(name, null, null, at, tokens.start() + 1);
      if (!field.isEmpty() && !Statements.is(name)) {
        document.container(field, at);
      }
      boolean node = catalogue.find(name).isPresent();
      while (tokens.next() == JsonToken.FIELD_NAME) {
        String member = tokens.text();
        int start = tokens.start();
        tokens.next();
        member(name, node, member, start);
      }
      document.close(tokens.start() + 1);
    }

    private void member(String element, boolean node, String member, int at)
        throws XmlParseException {
      String rest = member.isEmpty() ? "" : member.substring(1);
      switch (member.isEmpty() ? ' ' : member.charAt(0)) {
        // a prefix denotes another namespace, as in XML
        case '@' -> attribute(element, rest.indexOf(':') < 0 ? rest : "", at);
        case '-' -> contained(node ? rest : "", at);
        case '#' -> {
          int where = tokens.start();
          String words = String.join("\n", strings());
          if (member.equals("#comment")) {
            document.comment(words, where);
          } else {
            document.text(words, where);
          }
        }
        default -> elements(member, at);
      }
    }

    /** Reads an element, or an array of elements of one name; ignores any other value. */
    private void elements(String name, int at) throws XmlParseException {
      if (tokens.now() == JsonToken.START_OBJECT) {
        element(name, at, "");
      } else if (tokens.now() == JsonToken.START_ARRAY) {
        while (tokens.next() != JsonToken.END_ARRAY) {
          if (tokens.now() == JsonToken.START_OBJECT) {
            element(name, tokens.start(), "");
          } else {
            tokens.skip();
          }
        }
      }
    }

    /** Reads the elements in a field: an object of one or more elements, or an array of such. */
    private void contained(String field, int at) throws XmlParseException {
      if (tokens.now() == JsonToken.START_ARRAY) {
        while (tokens.next() != JsonToken.END_ARRAY) {
          contained(field, at);
        }
      } else if (tokens.now() == JsonToken.START_OBJECT) {
        while (tokens.next() == JsonToken.FIELD_NAME) {
          String name = tokens.text();
          int start = tokens.start();
          JsonToken value = tokens.next();
          if (name.startsWith("#")) {
            document.comment(String.join("\n", strings()), start);
          } else if (value == JsonToken.START_OBJECT) {
            element(name, start, field);
          } else {
            throw unexpected("an object {...} of " + FieldTokenizer.quote(name));
          }
        }
      } else if (tokens.now() != JsonToken.VALUE_NULL) {
        throw unexpected("a node, or a list of nodes,");
      }
    }

    private XmlParseException unexpected(String wanted) {
      return document.fault(tokens.start(), wanted + " must stand here");
    }

    private void attribute(String element, String name, int at) throws XmlParseException {
      int from = tokens.start();
      switch (tokens.now()) {
        case VALUE_STRING -> {
          String text = tokens.text();
          boolean whole = several(element, name) && !text.stripLeading().startsWith("\"");
          int to = from + 1 + text.length();
          document.attribute(name, whole ? FieldTokenizer.string(text) : text, at, from + 1, to);
          name(name, text);
        }
        case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT, VALUE_TRUE, VALUE_FALSE ->
            document.attribute(name, tokens.text(), at, from, from + tokens.text().length());
        case START_ARRAY -> list(name, at, from + 1);
        case VALUE_NULL -> {
          // null means that the attribute is absent
        }
        default -> throw unexpected("the value of " + FieldTokenizer.quote(name));
      }
    }

    private void name(String attribute, String text) {
      if (attribute.equals("DEF")) {
        document.named(text, document.element().use().orElse(null));
      } else if (attribute.equals("USE")) {
        document.named(document.element().def().orElse(null), text);
      }
    }

    private boolean several(String element, String field) {
      return catalogue
          .find(element)
          .flatMap(type -> type.field(field))
          .filter(found -> found.type() == FieldType.MFString)
          .isPresent();
    }

    private void list(String name, int at, int from) throws XmlParseException {
      JsonToken first = tokens.next();
      if (first == JsonToken.VALUE_STRING) {
        int start = tokens.start();
        StringBuilder all = new StringBuilder();
        for (; tokens.now() != JsonToken.END_ARRAY; tokens.next()) {
          all.append(all.length() == 0 ? "" : " ").append(FieldTokenizer.string(tokens.scalar()));
        }
        document.attribute(name, all.toString(), at, start, tokens.start());
        return;
      }
      int start = first == JsonToken.END_ARRAY ? from : tokens.start();
      for (int depth = 1; ; tokens.next()) {
        switch (tokens.now()) {
          case START_ARRAY -> depth++;
          case END_ARRAY -> depth--;
          default -> tokens.scalar();
        }
        if (depth == 0) {
          document.attribute(name, at, start, Math.max(start, tokens.start()));
          return;
        }
      }
    }

    /** Reads a string, or an array of strings that are its lines. */
    private List<String> strings() throws XmlParseException {
      if (tokens.now() != JsonToken.START_ARRAY) {
        return List.of(tokens.scalar());
      }
      List<String> lines = new ArrayList<>();
      while (tokens.next() != JsonToken.END_ARRAY) {
        lines.add(tokens.scalar());
      }
      return lines;
    }
  }

  /** Recognizes the elements that are statements, which are not contained in a field of a node. */
  private static final class Statements {
    private Statements() {}

    static boolean is(String element) {
      return switch (element) {
        case "ROUTE",
            "IMPORT",
            "EXPORT",
            "IS",
            "connect",
            "ProtoDeclare",
            "ProtoInterface",
            "ProtoBody",
            "ExternProtoDeclare",
            "field",
            "fieldValue" ->
            true;
        default -> false;
      };
    }
  }
}
