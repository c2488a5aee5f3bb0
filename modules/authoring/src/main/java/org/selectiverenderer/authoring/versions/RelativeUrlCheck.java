package org.selectiverenderer.authoring.versions;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds the relative URLs of a scene. */
final class RelativeUrlCheck {
  private static final Pattern ABSOLUTE =
      Pattern.compile("[/#].*|[A-Za-z][A-Za-z0-9+.-]+:.*", Pattern.DOTALL);

  private record Named(SourceLocation location, String url) {}

  private RelativeUrlCheck() {}

  /**
   * Warns about relative URLs of a file that will be written to another folder.
   *
   * @param apart elements whose URLs are adapted and need no warning
   */
  static void warn(
      ElementNodeMapping scene,
      List<DocumentElement> apart,
      Path outputFolder,
      ProblemCollector problems) {
    List<Named> found = new ArrayList<>();
    scene
        .elements()
        .root()
        .visit(
            element -> {
              NodeView node = element.use().isPresent() ? null : scene.node(element);
              if (node != null && apart.stream().noneMatch(other -> other.contains(element))) {
                collect(node, element.location(), found);
              }
            });
    if (!found.isEmpty()) {
      problems.warning(
          found.get(0).location(),
          ("%s here (%s in all) is relative to this file's folder and will not be "
                      + "found from %s")
                  .formatted(
                      found.get(0).url(), Pluralizer.of(found.size(), "such URL"), outputFolder)
              + " unless the files are copied too");
    }
  }

  private static void collect(NodeView node, SourceLocation location, List<Named> found) {
    for (FieldDefinition field : node.type().fields()) {
      boolean url = field.name().toLowerCase(Locale.ROOT).endsWith("url");
      if (url && node.value(field.index()) instanceof String[] urls) {
        for (String address : urls) {
          if (!address.isBlank() && !ABSOLUTE.matcher(address.strip()).matches()) {
            found.add(new Named(location, address));
            break;
          }
        }
      }
    }
  }
}
