package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;

class FrameBudgetQueueTest {
  private final Queue<Runnable> posted = new ArrayDeque<>();
  private final List<String> there = new ArrayList<>();
  private final FrameBudgetQueue arrivals = new FrameBudgetQueue(posted::add);

  private void read(String name, long work) {
    arrivals.add(work, () -> there.add(name));
  }

  /** As a world does: what is posted by then, then the rest of the frame. Returns what arrived. */
  private List<String> frame() {
    there.clear();
    for (int open = posted.size(); open > 0; open--) {
      posted.remove().run();
    }
    arrivals.frame();
    arrivals.frame(); // A frame settles twice.
    return List.copyOf(there);
  }

  @Test
  void littleArrivesInOneFrame() {
    for (int i = 0; i < 100; i++) {
      read("file" + i, FrameBudgetQueue.MOST / 200);
    }
    assertThat(frame()).hasSize(100);
    assertThat(posted).isEmpty();
  }

  @Test
  void muchIsSpreadOverFramesInItsOrder() {
    for (int i = 0; i < 5; i++) {
      read("file" + i, FrameBudgetQueue.MOST / 2);
    }
    assertThat(frame()).containsExactly("file0", "file1");
    assertThat(frame()).containsExactly("file2", "file3");
    assertThat(frame()).containsExactly("file4");
    assertThat(frame()).isEmpty();
    assertThat(posted).isEmpty();
  }

  @Test
  void whatIsReadMeanwhileComesAfterWhatIsLate() {
    read("large", 10 * FrameBudgetQueue.MOST);
    read("late", 1);
    assertThat(frame()).containsExactly("large");
    read("new", 1);
    assertThat(frame()).containsExactly("late", "new");
  }

  @Test
  void whatAnArrivalReadsWaitsForItsTurn() {
    arrivals.add(1, () -> read("inner", 1));
    read("next", 1);
    assertThat(frame()).containsExactly("next");
    assertThat(frame()).containsExactly("inner");
  }
}
