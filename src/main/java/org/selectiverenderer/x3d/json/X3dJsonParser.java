package org.selectiverenderer.x3d.json;

import com.fasterxml.jackson.core.JsonToken;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.Tokens;
import org.selectiverenderer.x3d.source.DocumentBuilder;
import org.selectiverenderer.x3d.source.ValueCleaner;
import org.selectiverenderer.x3d.source.XmlFault;

/** Reads a file: elements within elements, from X3D down. */
public final class X3dJsonParser implements DocumentBuilder.Parser {
  private final NodeCatalogue catalogue;

  /** A parser that knows the node types of a catalogue. */
  public X3dJsonParser(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Lists of lists, which some programs write, are lists of all their numbers. */
  @Override
  public ValueCleaner cleaner() {
    return (value, length) -> {
      for (int i = 0; i < length; i++) {
        if (value[i] == '[' || value[i] == ']') {
          value[i] = ' ';
        }
      }
    };
  }

  @Override
  public void parse(DocumentBuilder document) throws XmlFault {
    try (JsonTokens tokens = new JsonTokens(document)) {
      new Reading(document, tokens, catalogue).file();
    }
  }

  /** One file. */
  private record Reading(DocumentBuilder document, JsonTokens tokens, NodeCatalogue catalogue) {
    void file() throws XmlFault {
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
            0, "this is JSON, but no scene: that is an object with a member \"X3D\"");
      }
      tokens.end();
    }

    /**
     * Reads the object that has begun.
     *
     * @param at offset of the element's name
     * @param field of the node around it that it is in; empty where no field is named
     */
    private void element(String name, int at, String field) throws XmlFault {
      document.open(name, null, null, at, tokens.start() + 1);
      if (!field.isEmpty() && !JsonStatement.is(name)) {
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

    private void member(String element, boolean node, String member, int at) throws XmlFault {
      String rest = member.isEmpty() ? "" : member.substring(1);
      switch (member.isEmpty() ? ' ' : member.charAt(0)) {
        // What has a prefix belongs to another language, as in XML.
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

    /** One element, or a list of elements of one name; what is neither says nothing of a scene. */
    private void elements(String name, int at) throws XmlFault {
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

    /** The elements in a field: an object of one or more, or a list of such. */
    private void contained(String field, int at) throws XmlFault {
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
            throw unexpected("the members of " + Tokens.quote(name) + " in curly brackets");
          }
        }
      } else if (tokens.now() != JsonToken.VALUE_NULL) {
        throw unexpected("a node, or a list of nodes,");
      }
    }

    private XmlFault unexpected(String wanted) {
      return document.fault(tokens.start(), wanted + " must stand here");
    }

    private void attribute(String element, String name, int at) throws XmlFault {
      int from = tokens.start();
      switch (tokens.now()) {
        case VALUE_STRING -> {
          String text = tokens.text();
          boolean whole = several(element, name) && !text.stripLeading().startsWith("\"");
          int to = from + 1 + text.length();
          document.attribute(name, whole ? Tokens.string(text) : text, at, from + 1, to);
          name(name, text);
        }
        case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT, VALUE_TRUE, VALUE_FALSE ->
            document.attribute(name, tokens.text(), at, from, from + tokens.text().length());
        case START_ARRAY -> list(name, at, from + 1);
        case VALUE_NULL -> {
          // As if it were not there.
        }
        default -> throw unexpected("the value of " + Tokens.quote(name));
      }
    }

    private void name(String attribute, String text) {
      if (attribute.equals("DEF")) {
        document.named(text, null);
      } else if (attribute.equals("USE")) {
        document.named(null, text);
      }
    }

    private boolean several(String element, String field) {
      return catalogue
          .find(element)
          .flatMap(type -> type.field(field))
          .filter(found -> found.type() == FieldType.MFString)
          .isPresent();
    }

    private void list(String name, int at, int from) throws XmlFault {
      JsonToken first = tokens.next();
      if (first == JsonToken.VALUE_STRING) {
        int start = tokens.start();
        StringBuilder all = new StringBuilder();
        for (; tokens.now() != JsonToken.END_ARRAY; tokens.next()) {
          all.append(all.length() == 0 ? "" : " ").append(Tokens.string(tokens.scalar()));
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

    /** A string, or a list of strings that are lines of one. */
    private List<String> strings() throws XmlFault {
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
}
