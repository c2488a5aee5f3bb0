package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentError.Kind;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.ValueCommentStripper;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.vrml.VrmlScanner;

/** Parses a file of VRML 1.0 to the elements of the X3D scene that shows the same. */
public final class Vrml1Parser implements ElementTreeBuilder.Parser {
  /**
   * The version of X3D in which a texture multiplies the colour of the material, as in VRML 1.0.
   */
  private static final String VERSION = "4.0";

  private static final String PROFILE = "Immersive";

  private static final Comparator<SourceLocation> IN_TEXT =
      Comparator.comparingInt(SourceLocation::line).thenComparingInt(SourceLocation::column);

  @Override
  public ValueCommentStripper cleaner() {
    return VrmlScanner::clean;
  }

  @Override
  public void parse(ElementTreeBuilder document) throws XmlParseException {
    PendingComments comments = new PendingComments();
    VrmlScanner scanner = new VrmlScanner(document, comments);
    while (scanner.peek() != '#') {
      scanner.step(); // white space, which the detection of the encoding skips
    }
    int start = scanner.at();
    scanner.line();
    int body = scanner.at();
    Vrml1NodeParser nodes = new Vrml1NodeParser(document, scanner);
    Vrml1Node root = new Vrml1Node("Group", null, start, start);
    List<XmlParseException> faults = new ArrayList<>();
    try {
      nodes.scene(root);
    } catch (XmlParseException e) {
      faults.add(e); // what was before is shown
    }
    X3dElement scene = new X3dElement("Scene", body - 1, scanner.at());
    Vrml1Translator translator = new Vrml1Translator(document, nodes.names(), scene);
    try {
      translator.scene(root);
    } catch (XmlParseException e) {
      faults.add(e);
    }
    try {
      write(document, comments, scene, translator.usesOrthographicCamera(), start);
    } catch (XmlParseException e) {
      faults.add(e);
    }
    tell(document, faults);
  }

  /** Tells the syntax error and the first limit that was exceeded, in the order of the text. */
  private static void tell(ElementTreeBuilder document, List<XmlParseException> faults)
      throws XmlParseException {
    faults.sort(Comparator.comparing(e -> e.fault().location(), IN_TEXT));
    XmlParseException last = null;
    boolean limited = false;
    for (XmlParseException fault : faults) {
      boolean limit = fault.fault().kind() == Kind.LIMIT;
      if (limit && limited) {
        continue;
      }
      limited |= limit;
      if (last != null) {
        document.tell(last);
      }
      last = fault;
    }
    if (last != null) {
      throw last;
    }
  }

  private static void write(
      ElementTreeBuilder document,
      PendingComments comments,
      X3dElement scene,
      boolean orthographic,
      int start)
      throws XmlParseException {
    document.open("X3D", null, null, start, start);
    document.attribute("profile", PROFILE, start);
    document.attribute("version", VERSION, start);
    if (orthographic) {
      document.open("head", null, null, start, start);
      document.open("component", null, null, start, start);
      document.attribute("name", "Navigation", start);
      document.attribute("level", "3", start);
      document.close(start);
      document.close(start);
    }
    scene.write(document, comments, 1);
    comments.before(Integer.MAX_VALUE, document);
    document.close(document.text().length());
  }
}
