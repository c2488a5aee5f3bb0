package org.selectiverenderer.authoring.importing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.structure.NeededComponents;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.UrlRelativizer;

/** Creates edits that inline a file in a scene. */
public final class InlineEdits {
  private static final Set<String> STATEMENTS = Set.of("ROUTE", "IMPORT", "EXPORT");
  private static final int DECIMALS = 4;

  private final SceneDocument document;
  private final NodeCatalogue catalogue;

  /** Creates edits of a document with nodes of a catalogue. */
  public InlineEdits(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
  }

  /**
   * An edit that adds an Inline.
   *
   * @param name the DEF name of the new Transform around it
   */
  public record Added(Edit edit, String name) {}

  /**
   * Adds a Transform with an Inline of a file at the end of the scene, before its routes.
   *
   * @param scene the scene's file, relative to which the url is
   * @throws EditRejectedException if the text is not well-formed, or has no Scene
   */
  public Added add(Path scene, Path file, Vector3dc translation) {
    ElementTree tree =
        document
            .tree()
            .orElseThrow(
                () ->
                    new EditRejectedException(
                        "the scene is not well-formed XML; correct it in the source first"));
    DocumentElement top =
        tree.scene()
            .orElseThrow(() -> new EditRejectedException("the file has no Scene to add it to"));
    String stem = String.valueOf(file.getFileName());
    int dot = stem.indexOf('.', 1);
    String name =
        new UniqueNameGenerator(tree, top)
            .free(named(UniqueNameGenerator.identifier(dot < 0 ? stem : stem.substring(0, dot))));
    Path folder = scene.toAbsolutePath().normalize().getParent();
    String url = '"' + UrlRelativizer.between(folder, file).replace("\"", "%22") + '"';
    SourceFormatter layout = document.layout();
    char quote = layout.quote(top.children().isEmpty() ? top : top.children().get(0));
    String place =
        number(translation.x()) + " " + number(translation.y()) + " " + number(translation.z());
    List<String> lines =
        List.of(
            "<Transform"
                + SourceFormatter.written("DEF", name, quote)
                + SourceFormatter.written("translation", place, quote)
                + ">",
            layout.step(top) + "<Inline" + SourceFormatter.written("url", url, '\'') + "/>",
            "</Transform>");
    Optional<DocumentElement> last =
        top.children().stream()
            .filter(child -> !STATEMENTS.contains(child.name()))
            .reduce((one, other) -> other);
    List<TextEdit> changes =
        new ArrayList<>(
            new NeededComponents(document, catalogue).of(Set.of("Transform", "Inline")));
    changes.add(
        last.map(child -> layout.insertAfter(child, lines))
            .orElseGet(() -> layout.insertFirst(top, lines)));
    return new Added(new Edit("Import " + name, changes), name);
  }

  /** Returns a name that begins with a letter, as names of nodes do. */
  private static String named(String wanted) {
    return wanted.isEmpty() || !Character.isLetter(wanted.charAt(0)) ? "Model_" + wanted : wanted;
  }

  private static String number(double of) {
    return DecimalFormatter.rounded(of, DECIMALS);
  }
}
