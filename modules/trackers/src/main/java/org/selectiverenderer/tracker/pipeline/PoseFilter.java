package org.selectiverenderer.tracker.pipeline;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/** A filter that changes each record; used by one thread; allocates nothing per record. */
public interface PoseFilter {
  /** Changes the angles in place; the filter's clock is the time of arrival. */
  void apply(PoseSample sample);

  /** Returns the chain of filters for the options. */
  static PoseFilter of(TrackerOptions options) {
    List<PoseFilter> filters = new ArrayList<>();
    if (options.swapped().isPresent() || !options.inverted().isEmpty()) {
      filters.add(new AxisRemapFilter(options.swapped(), options.inverted()));
    }
    options.smoothing().ifPresent(smoothing -> filters.add(new OneEuroFilter(smoothing)));
    if (options.prediction() > 0) {
      filters.add(new PredictionFilter(options.prediction()));
    }
    PoseFilter[] chain = filters.toArray(PoseFilter[]::new);
    return sample -> {
      for (PoseFilter filter : chain) {
        filter.apply(sample);
      }
    };
  }
}
