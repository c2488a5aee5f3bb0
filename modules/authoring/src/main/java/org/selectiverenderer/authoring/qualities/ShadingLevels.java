package org.selectiverenderer.authoring.qualities;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** Plans levels of shading for the Appearances of an object. */
final class ShadingLevels {
  private static final String BEST = "pixel";

  private final SceneDocument document;
  private final NodeNaming names;

  ShadingLevels(SceneDocument document, NodeNaming names) {
    this.document = document;
    this.names = names;
  }

  /**
   * @param levels the words after the best, {@code pixel}
   * @param schemas one for {@code pixel} and each level, or none
   * @throws EditRejectedException if an Appearance has metadata that leave no room for it
   */
  QualityLevels of(DocumentElement object, List<String> levels, List<String> schemas, String name) {
    List<FieldQuality> qualities = new ArrayList<>();
    List<TextEdit> changes = new ArrayList<>();
    List<List<String>> values =
        Stream.concat(Stream.of(BEST), levels.stream()).map(List::of).toList();
    for (DocumentElement appearance : names.own(object, "Appearance")) {
      String def = string(appearance, name + "_Shading", changes);
      qualities.add(
          new FieldQuality(
              Quality.SHADING,
              new FieldReference(def, "value"),
              LevelMetadata.levels(values, schemas)));
    }
    return new QualityLevels(qualities, changes, List.of());
  }

  /** Returns the name of the MetadataString of an Appearance, which is added if it is not there. */
  private String string(DocumentElement appearance, String wanted, List<TextEdit> changes) {
    Optional<DocumentElement> metadata =
        appearance.children().stream()
            .filter(child -> child.name().startsWith("Metadata"))
            .findFirst();
    if (metadata.isEmpty()) {
      String name = names.unused(wanted);
      changes.add(
          document.layout().insertFirst(appearance, List.of(text(appearance, name, "metadata"))));
      return name;
    }
    DocumentElement found = metadata.get();
    Optional<DocumentElement> known =
        Stream.concat(Stream.of(found), found.children().stream())
            .filter(element -> element.name().equals("MetadataString"))
            .filter(element -> element.text("name").filter("shading"::equals).isPresent())
            .findFirst();
    if (known.isPresent()) {
      return names.of(known.get(), wanted, changes);
    }
    if (!found.name().equals("MetadataSet") || found.use().isPresent()) {
      throw new EditRejectedException(
          found.location()
              + ": the Appearance has other metadata already; put them into a MetadataSet first");
    }
    String name = names.unused(wanted);
    changes.add(document.layout().insertLast(found, List.of(text(appearance, name, "value"))));
    return name;
  }

  private String text(DocumentElement near, String name, String field) {
    char quote = document.layout().quote(near);
    return "<MetadataString"
        + SourceFormatter.written("containerField", field, quote)
        + SourceFormatter.written("DEF", name, quote)
        + SourceFormatter.written("name", "shading", quote)
        + SourceFormatter.written("value", "\"" + BEST + "\"", '\'')
        + "/>";
  }
}
