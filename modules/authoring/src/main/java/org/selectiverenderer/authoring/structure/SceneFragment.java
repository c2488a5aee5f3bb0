package org.selectiverenderer.authoring.structure;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * Nodes that were read from text, such as that of the clipboard: one or several elements of X3D, a
 * whole X3D file, of which the content of its Scene counts, or VRML97.
 */
final class SceneFragment {
  private static final int LONGEST = 64_000_000;
  private static final String HEADER = "#VRML V2.0 utf8\n";
  private static final Pattern VRML_NODE =
      Pattern.compile("(?s)(DEF\\s+\\S+\\s+|PROTO\\s+)?[A-Z]\\w*\\s*[\\[{].*");

  private final SceneDocument document;
  private final List<DocumentElement> elements;

  private SceneFragment(SceneDocument document, List<DocumentElement> elements) {
    this.document = document;
    this.elements = List.copyOf(elements);
  }

  /**
   * Reads nodes from text.
   *
   * @throws EditRejectedException if there are none, with a sentence for the author
   */
  static SceneFragment parse(String text, NodeCatalogue catalogue) {
    if (text.length() > LONGEST) {
      throw new EditRejectedException(
          "The clipboard holds more than %d million characters; use an Inline of the file"
              .formatted(LONGEST / 1_000_000));
    }
    String stripped = (text.startsWith("\uFEFF") ? text.substring(1) : text).strip();
    if (stripped.startsWith("#VRML") || stripped.startsWith("#X3D")) {
      return of(xml(stripped, catalogue));
    }
    if (VRML_NODE.matcher(stripped).matches()) {
      return of(xml(HEADER + stripped, catalogue));
    }
    boolean whole =
        stripped.startsWith("<?xml")
            || stripped.startsWith("<!DOCTYPE")
            || stripped.startsWith("<X3D");
    return of(whole ? stripped : "<Scene>" + stripped + "</Scene>");
  }

  private static SceneFragment of(String xml) {
    SceneDocument document;
    try {
      document = SceneDocument.of("clipboard", xml.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new EditRejectedException("The clipboard holds no X3D node: " + e.getMessage());
    }
    DocumentElement root =
        document
            .tree()
            .orElseThrow(
                () ->
                    new EditRejectedException(
                        "The clipboard holds no well-formed X3D"
                            + document.fault().map(fault -> ": " + fault.message()).orElse("")))
            .root();
    Optional<DocumentElement> scene =
        root.name().equals("Scene")
            ? Optional.of(root)
            : root.children().stream().filter(child -> child.name().equals("Scene")).findFirst();
    List<DocumentElement> elements = scene.map(DocumentElement::children).orElse(List.of());
    if (elements.isEmpty()) {
      throw new EditRejectedException(
          "The clipboard holds no X3D node; copy one, or the X3D or VRML source of one");
    }
    return new SceneFragment(document, elements);
  }

  private static String xml(String vrml, NodeCatalogue catalogue) {
    byte[] bytes = vrml.getBytes(StandardCharsets.UTF_8);
    try {
      XmlDocument read =
          new X3dReader(catalogue)
              .document("clipboard.wrl", new ByteArrayInputStream(bytes), bytes.length);
      if (read.broken()) {
        throw new EditRejectedException(
            "The clipboard holds VRML that cannot be read"
                + read.faults().stream()
                    .findFirst()
                    .map(fault -> ": " + fault.message())
                    .orElse(""));
      }
      return SceneFormat.XML.text(read, catalogue, new ProblemCollector());
    } catch (IOException e) {
      throw new EditRejectedException("The clipboard holds no VRML node: " + e.getMessage());
    }
  }

  /** Returns the document that the elements are of. */
  SceneDocument document() {
    return document;
  }

  /** Returns the elements in order, at least one. */
  List<DocumentElement> elements() {
    return elements;
  }
}
