package org.selectiverenderer.models;

import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedAnimation;
import org.selectiverenderer.models.importer.ImportedModel.ImportedChannel;
import org.selectiverenderer.models.scene.AnimationWriter;
import org.selectiverenderer.models.scene.Keyframes;

/** Writes the animations of an imported model. */
final class ImportedAnimationWriter {
  private final ImportedModel model;
  private final AnimationWriter out;
  private final ModelSource file;
  private final ProblemCollector problems;

  ImportedAnimationWriter(
      ImportedModel model, AnimationWriter out, ModelSource file, ProblemCollector problems) {
    this.model = model;
    this.out = out;
    this.file = file;
    this.problems = problems;
  }

  void write() {
    for (int i = 0; i < model.animations().size(); i++) {
      write(model.animations().get(i), "animation" + i);
    }
    if (model.animations().stream().anyMatch(ImportedAnimation::morphs)) {
      problems.warning(
          SourceLocation.of(file.name()),
          "an animation changes shapes by morph targets, which is not read; they stay as they are");
    }
  }

  private void write(ImportedAnimation animation, String otherwise) {
    float first = Float.POSITIVE_INFINITY;
    float last = Float.NEGATIVE_INFINITY;
    for (ImportedChannel channel : animation.channels()) {
      for (float[] times :
          Stream.of(channel.translationTimes(), channel.rotationTimes(), channel.scaleTimes())
              .filter(ImportedAnimationWriter::increases)
              .toList()) {
        first = Math.min(first, times[0]);
        last = Math.max(last, times[times.length - 1]);
      }
    }
    float start = first < 0 ? first : 0; // some begin before 0
    if (!(last - start > 0)) {
      return;
    }
    out.begin(animation.name(), otherwise, last - start);
    for (ImportedChannel channel : animation.channels()) {
      move(channel, "translation", channel.translationTimes(), channel.translations(), start);
      move(channel, "rotation", channel.rotationTimes(), channel.rotations(), start);
      move(channel, "scale", channel.scaleTimes(), channel.scales(), start);
    }
  }

  private void move(
      ImportedChannel channel, String field, float[] times, float[] values, float start) {
    if (!increases(times)) {
      return;
    }
    float[] since = new float[times.length];
    for (int i = 0; i < times.length; i++) {
      since[i] = times[i] - start;
    }
    float[] finite = ImportedModelConverter.clean(values);
    out.move(channel.node(), field, new Keyframes(since, finite, values.length / times.length));
  }

  /** Returns whether there are times, all finite, none before the one before it. */
  private static boolean increases(float[] times) {
    for (int i = 0; i < times.length; i++) {
      if (!Float.isFinite(times[i]) || i > 0 && times[i] < times[i - 1]) {
        return false;
      }
    }
    return times.length > 0;
  }
}
