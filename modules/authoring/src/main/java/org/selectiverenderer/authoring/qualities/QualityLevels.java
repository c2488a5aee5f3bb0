package org.selectiverenderer.authoring.qualities;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Qualities of an object that are to be written into its scene.
 *
 * @param qualities the fields and their levels, the best level first
 * @param changes changes inside the object that make the fields nameable
 * @param files the pictures that the levels show
 */
record QualityLevels(
    List<FieldQuality> qualities, List<TextEdit> changes, List<PlannedFile> files) {
  QualityLevels {
    qualities = List.copyOf(qualities);
    changes = List.copyOf(changes);
    files = List.copyOf(files);
  }

  QualityLevels and(QualityLevels more) {
    return new QualityLevels(
        both(qualities, more.qualities), both(changes, more.changes), both(files, more.files));
  }

  private static <T> List<T> both(List<T> one, List<T> other) {
    List<T> all = new ArrayList<>(one);
    all.addAll(other);
    return all;
  }
}
