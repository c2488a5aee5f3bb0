package org.selectiverenderer.tracker.live;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/** Changes each record on its way; used by one thread; allocates nothing per record. */
public interface PoseFilter {
  /** Changes the angles in place; the time of arrival is the filter's clock. */
  void apply(PoseSample sample);

  /** Filters for the options, in the order in which these say that they are applied. */
  static PoseFilter of(TrackerOptions options) {
    List<PoseFilter> filters = new ArrayList<>();
    if (options.swapped().isPresent() || !options.inverted().isEmpty()) {
      filters.add(new AxisFilter(options.swapped(), options.inverted()));
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
