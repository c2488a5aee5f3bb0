package org.selectiverenderer.x3d.source;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * The result of checking a file before parsing: its encoding, and the errors found by then.
 *
 * @param text the part of the text to parse
 * @param source the whole text
 * @param faults the errors; a single one of kind REFUSED if the file must not be parsed
 * @param encoding the encoding; XML if it is unknown
 */
public record Preflight(
    SourceText text, TextSource source, List<DocumentError> faults, SceneEncoding encoding) {
  /** Checks a file's bytes. */
  public static Preflight of(String name, SceneBytes bytes) {
    SourceText text = SourceText.of(bytes.bytes(), bytes.length());
    if (isBinary(bytes)) {
      return refused(
          name,
          text,
          "this is a scene in X3D's binary encoding (.x3db), which is not read; save it as X3D XML"
              + " in the program that made it, or convert it with Xj3D's converter");
    }
    SourceLocation whole = SourceLocation.of(name);
    if (bytes.refused() != null) {
      return refused(name, text, bytes.refused());
    }
    List<DocumentError> faults = new ArrayList<>();
    if (text.complaint() != null) {
      faults.add(new DocumentError(Kind.ENCODING, whole, text.complaint()));
    }
    if (bytes.cut() != null) {
      SourceLocation end = new TextSource(name, text).location(text.length());
      faults.add(new DocumentError(Kind.COMPRESSION, end, bytes.cut()));
      if (text.length() == 0) {
        return new Preflight(text, new TextSource(name, text), faults, SceneEncoding.XML);
      }
    }
    return of(name, text, faults, true);
  }

  /**
   * Returns whether a file is a Fast Infoset, as ISO/IEC 19776-3 has it (ITU-T X.891, 12.6), or in
   * EXI, which has been proposed in its place.
   */
  private static boolean isBinary(SceneBytes file) {
    byte[] bytes = file.bytes();
    return starts(bytes, file.length(), 0xe0, 0, 0, 1)
        || starts(bytes, file.length(), '$', 'E', 'X', 'I');
  }

  private static boolean starts(byte[] bytes, int length, int... magic) {
    return length >= magic.length
        && IntStream.range(0, magic.length).allMatch(i -> (bytes[i] & 0xff) == magic[i]);
  }

  /** Checks a text and expands its entities. */
  public static Preflight of(String name, SourceText text) {
    return of(name, text, new ArrayList<>(), true);
  }

  /** Returns the X3D text that a model was translated into, and what was left out of it. */
  public static Preflight translated(String name, String x3d, List<DocumentError> faults) {
    byte[] bytes = x3d.getBytes(StandardCharsets.UTF_8);
    SourceText text = SourceText.of(bytes, bytes.length);
    return new Preflight(text, TextSource.translated(name, text), faults, SceneEncoding.XML);
  }

  /** Returns the result of refusing a file. */
  public static Preflight refused(String name, String why) {
    return refused(name, SourceText.of(""), why);
  }

  /** Checks a text whose offsets must remain, so that its entities are not expanded. */
  static Preflight unexpanded(String name, SourceText text) {
    return of(name, text, new ArrayList<>(), false);
  }

  private static Preflight of(
      String name, SourceText text, List<DocumentError> faults, boolean expand) {
    String head = text.head(SceneEncoding.HEAD);
    SceneEncoding encoding = SceneEncoding.of(head).orElse(null);
    if (encoding == null) {
      return refused(name, text, foreign(head));
    }
    TextSource source = new TextSource(name, text);
    EntityTable entities =
        expand && encoding == SceneEncoding.XML ? EntityTable.of(text) : EntityTable.NONE;
    return entities.none()
        ? checked(text, source, faults, encoding)
        : expanded(text, source, faults, entities);
  }

  private static Preflight expanded(
      SourceText original, TextSource source, List<DocumentError> faults, EntityTable entities) {
    EntityExpander expander = EntityExpander.of(original, entities);
    EntityReferenceScanner.TooLong limit = expander.limit();
    if (limit != null) {
      faults.add(limit.fault(source, 0));
    }
    SourceText text = original.expandedTo(expander.text());
    TextSource expanded = source.expanded(text, entities, expander.mapping());
    return checked(text, expanded, faults, SceneEncoding.XML);
  }

  private static Preflight checked(
      SourceText text, TextSource source, List<DocumentError> faults, SceneEncoding encoding) {
    int flood = encoding == SceneEncoding.XML ? text.floodedTag() : -1;
    if (flood < 0) {
      return new Preflight(text, source, faults, encoding);
    }
    String why =
        "an element has more than " + SourceText.ATTRIBUTES + " attributes, more than any node has";
    faults.add(new DocumentError(Kind.LIMIT, source.location(flood), why));
    return new Preflight(text.cutAt(flood), source, faults, encoding);
  }

  private static Preflight refused(String name, SourceText text, String why) {
    DocumentError fault = new DocumentError(Kind.REFUSED, SourceLocation.of(name), why);
    return new Preflight(text, new TextSource(name, text), List.of(fault), SceneEncoding.XML);
  }

  /** Returns the message about a file in an unknown encoding. */
  private static String foreign(String head) {
    String start = head.stripLeading();
    if (start.startsWith("#Inventor")) {
      return "this is a scene of Open Inventor, which is not read; convert it to X3D, for example "
          + "with view3dscene";
    }
    if (head.isEmpty()) {
      return "the file is empty; nothing can be shown";
    }
    return "this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V', '#VRML V' "
        + "or '{'; nothing can be shown";
  }

  /** Returns a parser at the start of the text. */
  public XmlPullParser events() {
    return new XmlPullParser(source, text);
  }

  /** Returns whether the file must not be parsed. */
  public boolean refused() {
    return faults.size() == 1 && faults.get(0).kind() == Kind.REFUSED;
  }

  /** Returns the error that truncates the text; null if there is none. */
  @Nullable
  public DocumentError cut() {
    DocumentError last = faults.isEmpty() ? null : faults.get(faults.size() - 1);
    boolean whole = last == null || last.kind() == Kind.ENCODING || last.kind() == Kind.MODEL;
    return whole ? null : last;
  }
}
