package org.selectiverenderer.x3d.vrml1;

import org.jspecify.annotations.Nullable;
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
    XmlParseException fault = null;
    try {
      nodes.scene(root);
    } catch (XmlParseException e) {
      fault = e; // what was before is shown
    }
    X3dElement scene = new X3dElement("Scene", body - 1, scanner.at());
    Vrml1Translator translator = new Vrml1Translator(document, nodes.names(), scene);
    try {
      translator.scene(root);
    } catch (XmlParseException e) {
      fault = fault == null ? e : fault;
    }
    write(document, comments, scene, translator.usesOrthographicCamera(), start);
    throwIfAny(fault);
  }

  private static void throwIfAny(@Nullable XmlParseException fault) throws XmlParseException {
    if (fault != null) {
      throw fault;
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
    scene.write(document, comments);
    comments.before(Integer.MAX_VALUE, document);
    document.close(document.text().length());
  }
}
