package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.source.DocumentFault.Kind;

/**
 * What can be said of a file before it is parsed.
 *
 * @param text what is left to parse
 * @param source all of the text
 * @param faults a single one if nothing is to be read
 * @param encoding XML where it is none that is read
 */
public record Preflight(
    SourceText text, TextSource source, List<DocumentFault> faults, Encoding encoding) {
  /** Looks at a file's bytes. */
  public static Preflight of(String name, SceneBytes bytes) {
    SourceText text = SourceText.of(bytes.bytes(), bytes.length());
    Location whole = Location.of(name);
    if (bytes.refused() != null) {
      return refused(name, text, bytes.refused());
    }
    List<DocumentFault> faults = new ArrayList<>();
    if (text.complaint() != null) {
      faults.add(new DocumentFault(Kind.ENCODING, whole, text.complaint()));
    }
    if (bytes.cut() != null) {
      Location end = new TextSource(name, text).location(text.length());
      faults.add(new DocumentFault(Kind.COMPRESSION, end, bytes.cut()));
      if (text.length() == 0) {
        return new Preflight(text, new TextSource(name, text), faults, Encoding.XML);
      }
    }
    return of(name, text, faults);
  }

  /** Looks at a text. */
  public static Preflight of(String name, SourceText text) {
    return of(name, text, new ArrayList<>());
  }

  private static Preflight of(String name, SourceText text, List<DocumentFault> faults) {
    String head = text.head(64);
    Encoding encoding = Encoding.of(head).orElse(null);
    if (encoding == null) {
      return refused(name, text, foreign(head));
    }
    TextSource source = new TextSource(name, text);
    int flood = encoding == Encoding.XML ? text.floodedTag() : -1;
    if (flood < 0) {
      return new Preflight(text, source, faults, encoding);
    }
    String why = "an element has more than " + SourceText.ATTRIBUTES + " attributes";
    faults.add(new DocumentFault(Kind.LIMIT, source.location(flood), why));
    return new Preflight(text.cutAt(flood), source, faults, encoding);
  }

  private static Preflight refused(String name, SourceText text, String why) {
    DocumentFault fault = new DocumentFault(Kind.REFUSED, Location.of(name), why);
    return new Preflight(text, new TextSource(name, text), List.of(fault), Encoding.XML);
  }

  /** What to say about a file that is of no encoding of X3D. */
  private static String foreign(String head) {
    String start = head.stripLeading();
    if (start.startsWith("#VRML") || start.startsWith("#Inventor")) {
      return "this is a scene of VRML 1.0 or Inventor, which is not read; convert it to X3D, for "
          + "example with view3dscene";
    }
    if (head.isEmpty()) {
      return "the file is empty; nothing can be shown";
    }
    return "this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V', '#VRML V2.0' "
        + "or '{'; nothing can be shown";
  }

  /** The parser at the start of the text. */
  public XmlEvents events() {
    return new XmlEvents(source, text);
  }

  /** Whether nothing is to be read. */
  public boolean refused() {
    return faults.size() == 1 && faults.get(0).kind() == Kind.REFUSED;
  }

  /** Why the text ends too early; null if it does not. */
  @Nullable
  public DocumentFault cut() {
    DocumentFault last = faults.isEmpty() ? null : faults.get(faults.size() - 1);
    return last == null || last.kind() == Kind.ENCODING ? null : last;
  }
}
