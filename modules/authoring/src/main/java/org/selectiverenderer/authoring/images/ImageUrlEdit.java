package org.selectiverenderer.authoring.images;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Creates the edit that has a scene name other files for its images. */
public final class ImageUrlEdit {
  private ImageUrlEdit() {}

  /**
   * Returns the edit: the url that named a missing file names the found one, relative to the scene;
   * further urls of the same field stay.
   *
   * @param found the files by references of the document's present state
   * @param folder the folder of the scene
   * @throws org.selectiverenderer.authoring.EditRejectedException if a value comes from an entity
   */
  public static Edit of(SceneDocument document, Map<ImageReference, Path> found, Path folder) {
    List<TextEdit> changes = new ArrayList<>();
    found.forEach(
        (reference, file) -> {
          List<String> urls = new ArrayList<>(reference.urls());
          urls.set(index(urls, file), UrlRelativizer.between(folder, file));
          String value = FieldValueFormatter.strings(urls);
          changes.add(document.layout().attribute(reference.element(), reference.field(), value));
        });
    return new Edit("Find missing images", changes);
  }

  /** Returns the index of the url with the name of a file, else the first. */
  private static int index(List<String> urls, Path file) {
    String name = String.valueOf(file.getFileName());
    for (int i = 0; i < urls.size(); i++) {
      if (ImageReference.fileName(urls.get(i)).filter(name::equalsIgnoreCase).isPresent()) {
        return i;
      }
    }
    return 0;
  }
}
