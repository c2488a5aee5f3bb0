package org.selectiverenderer.x3d.source;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import javax.xml.stream.XMLStreamConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParseErrors;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * Parses a file to a document. Long lists of numbers are parsed to values at once, so that a file
 * takes about as much memory as its text and its numbers. For one file.
 */
public final class DocumentParser extends ElementParser {
  private final XmlPullParser xml;
  private final NodeCatalogue catalogue;
  private final FieldParser parser;
  private final XmlDocument document;
  private final List<XmlDocument.Comment> comments = new ArrayList<>();
  private int prototypes;

  private DocumentParser(
      XmlPullParser xml, NodeCatalogue catalogue, ReadLimits limits, XmlDocument document) {
    super(xml, xml.source(), 0, 0, limits);
    this.xml = xml;
    this.catalogue = catalogue;
    this.parser = xml.source().parser();
    this.document = document;
  }

  /**
   * Parses a file of any encoding.
   *
   * @param others returns the parser for an encoding other than XML
   */
  public static XmlDocument parse(
      String name,
      SceneBytes bytes,
      NodeCatalogue catalogue,
      ReadLimits limits,
      Function<SceneEncoding, ElementTreeBuilder.Parser> others) {
    return parse(name, bytes, Preflight.of(name, bytes), catalogue, limits, others);
  }

  /**
   * Parses a file after its preflight, with the faults of that.
   *
   * @param bytes the file, to find the place of a byte that is not UTF-8
   * @param others returns the parser for an encoding other than XML
   */
  public static XmlDocument parse(
      String name,
      SceneBytes bytes,
      Preflight preflight,
      NodeCatalogue catalogue,
      ReadLimits limits,
      Function<SceneEncoding, ElementTreeBuilder.Parser> others) {
    XmlDocument document = new XmlDocument(name, bytes.compressed(), preflight.encoding());
    for (DocumentError fault : preflight.faults()) {
      boolean encoding = fault.kind() == Kind.ENCODING;
      SourceLocation at = encoding ? badByte(name, bytes) : fault.location();
      document.add(new DocumentError(fault.kind(), at, fault.message()));
    }
    if (!preflight.refused()) {
      fill(document, preflight, catalogue, limits, others);
    }
    return document;
  }

  /** Parses a file after its preflight, whose faults are not repeated. */
  public static XmlDocument parse(
      Preflight preflight,
      NodeCatalogue catalogue,
      ReadLimits limits,
      Function<SceneEncoding, ElementTreeBuilder.Parser> others) {
    String name = preflight.source().file();
    XmlDocument document = new XmlDocument(name, false, preflight.encoding());
    fill(document, preflight, catalogue, limits, others);
    return document;
  }

  private static void fill(
      XmlDocument document,
      Preflight preflight,
      NodeCatalogue catalogue,
      ReadLimits limits,
      Function<SceneEncoding, ElementTreeBuilder.Parser> others) {
    DocumentError fault;
    if (preflight.encoding() == SceneEncoding.XML) {
      fault = new DocumentParser(preflight.events(), catalogue, limits, document).parse();
    } else {
      fault = null;
      ElementTreeBuilder.Parser parser = others.apply(preflight.encoding());
      ElementTreeBuilder builder =
          new ElementTreeBuilder(preflight, document, catalogue, limits, parser.cleaner());
      try {
        parser.parse(builder);
      } catch (XmlParseException e) {
        fault = e.fault();
      }
      builder.flush();
    }
    boolean told = preflight.cut() != null && fault != null && fault.kind() != Kind.LIMIT;
    if (fault != null && !told) {
      document.add(fault);
    }
  }

  /** Returns the location of the first byte that is not UTF-8; else the start of the file. */
  private static SourceLocation badByte(String name, SceneBytes bytes) {
    ByteBuffer in = ByteBuffer.wrap(bytes.bytes(), 0, bytes.length());
    CharBuffer good = CharBuffer.allocate(bytes.length());
    CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(in, good, true);
    if (!result.isError()) {
      return new SourceLocation(name, 1, 1);
    }
    byte[] before = Arrays.copyOf(bytes.bytes(), in.position());
    SourceText text = SourceText.of(before, before.length);
    return new TextSource(name, text).location(text.length());
  }

  @Override
  void started(DocumentElement element, ElementLocation place) {
    prototypes += element.name().equals("ProtoDeclare") ? 1 : 0;
    element.place(place);
    element.attributes(attributes(element));
    document.add(element);
    flush(element);
  }

  @Override
  void ended(DocumentElement element) {
    flush(null);
    prototypes -= element.name().equals("ProtoDeclare") ? 1 : 0;
  }

  @Override
  void other(int event, @Nullable DocumentElement in) {
    switch (event) {
      case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
        if (in != null && !xml.blank()) {
          in.addText(xml.text(), xml.textStart());
        }
      }
      case XMLStreamConstants.COMMENT ->
          comments.add(
              new XmlDocument.Comment(xml.text(), xml.place().location(), xml.start(), null));
      case XMLStreamConstants.ENTITY_REFERENCE ->
          document.add(new DocumentError(Kind.ENTITY, xml.place().location(), xml.entityProblem()));
      case XMLStreamConstants.DTD -> document.type(xml.type());
      default -> {
        // processing instructions are not part of the scene
      }
    }
  }

  /** Adds the comments since the last tag, which precede an element. */
  private void flush(@Nullable DocumentElement before) {
    for (XmlDocument.Comment comment : comments) {
      document.add(comment.before(before));
    }
    comments.clear();
  }

  private List<DocumentAttribute> attributes(DocumentElement element) {
    int count = xml.attributes();
    if (count == 0) {
      return List.of();
    }
    NodeType node = catalogue.find(element.name()).orElse(null);
    List<DocumentAttribute> attributes = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      String name = xml.attributeName(i);
      FieldType type = numbers(node, name);
      // the text of a prototype's values is parsed again for each instance
      boolean kept = type == null || prototypes > 0;
      String text = kept ? xml.attributeText(i) : null;
      DocumentAttribute attribute = new DocumentAttribute(element, i, name, text);
      if (!kept) {
        FieldParseErrors flaws = new FieldParseErrors();
        Object value = xml.numbers(i, type, parser, flaws);
        attribute.keep(type, value, flaws.list());
      }
      attributes.add(attribute);
    }
    return attributes;
  }

  /** Returns the type of a field that is a list of numbers; null for all others. */
  static @Nullable FieldType numbers(@Nullable NodeType node, String attribute) {
    FieldDefinition field = node == null ? null : node.field(attribute).orElse(null);
    if (field == null || !field.type().multiple()) {
      return null;
    }
    return switch (field.type().kind()) {
      case BOOLEAN, INT, FLOAT, DOUBLE -> field.type();
      case STRING, NODE -> null;
    };
  }
}
