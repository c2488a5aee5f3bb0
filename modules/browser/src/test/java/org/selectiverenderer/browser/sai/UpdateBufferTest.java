package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.MFInt32;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.grouping.Switch;

/** When writes take effect. */
class UpdateBufferTest {
  private final SaiFixture sai =
      SaiFixture.showing("<Switch DEF='S'/><Switch DEF='T'/><WorldInfo DEF='W'/>");
  private final Switch s = sai.node("S", Switch.class);
  private final Switch t = sai.node("T", Switch.class);
  private final ExecutorService others = Executors.newCachedThreadPool();

  @AfterEach
  void close() throws InterruptedException {
    others.shutdownNow();
    assertThat(others.awaitTermination(10, TimeUnit.SECONDS)).isTrue();
    sai.close();
  }

  private <T> T elsewhere(Callable<T> task) throws Exception {
    return others.submit(task).get(30, TimeUnit.SECONDS);
  }

  @Test
  void aWriteIsReadBackAtOnce() {
    s.setWhichChoice(5);
    assertThat(s.getWhichChoice()).isEqualTo(5);
  }

  @Test
  void anUpdateTakesEffectAtItsEndAndInOneFrame() {
    List<String> heard = new ArrayList<>();
    for (Switch node : List.of(s, t)) {
      node.getField("whichChoice")
          .addX3DEventListener(e -> heard.add(s.getWhichChoice() + "," + t.getWhichChoice()));
    }
    MFString lines = (MFString) sai.node("W").getField("info");
    sai.browser.beginUpdate();
    s.setWhichChoice(1);
    lines.append("a");
    sai.browser.beginUpdate(); // does not nest
    t.setWhichChoice(2);
    lines.append("b");
    sai.step();
    assertThat(heard).isEmpty();
    assertThat(s.getWhichChoice()).isEqualTo(-1);
    sai.browser.endUpdate();

    assertThat(s.getWhichChoice()).isEqualTo(1);
    String[] all = new String[lines.getSize()];
    lines.getValue(all);
    assertThat(all).containsExactly("a", "b");
    sai.step();
    assertThat(heard).containsExactly("1,2", "1,2");
    sai.browser.endUpdate();
  }

  @Test
  void anUpdateOfOneThreadHoldsUpNoOther() throws Exception {
    sai.browser.beginUpdate();
    s.setWhichChoice(1);
    elsewhere(
        () -> {
          t.setWhichChoice(2);
          sai.browser.endUpdate();
          return null;
        });
    assertThat(t.getWhichChoice()).isEqualTo(2);
    assertThat(s.getWhichChoice()).isEqualTo(-1);
    sai.browser.endUpdate();
    assertThat(s.getWhichChoice()).isEqualTo(1);
  }

  @Test
  void aWriteThatFailsAtTheEndOfAnUpdateKeepsTheOthers() {
    MFString lines = (MFString) sai.node("W").getField("info");
    sai.browser.beginUpdate();
    lines.removeValue(3);
    s.setWhichChoice(1);
    assertThatThrownBy(sai.browser::endUpdate).isInstanceOf(ArrayIndexOutOfBoundsException.class);
    assertThat(s.getWhichChoice()).isEqualTo(1);
  }

  @Test
  void aWriteDuringAStepElsewhereIsDoneWhenTheStepHasEnded() throws Exception {
    CountDownLatch inStep = new CountDownLatch(1);
    CountDownLatch writing = new CountDownLatch(1);
    s.getField("whichChoice")
        .addX3DEventListener(
            event -> {
              inStep.countDown();
              await(writing);
              t.setWhichChoice(8); // the frame is not over: this is first
            });
    s.setWhichChoice(1);
    Future<?> step = others.submit(sai::step);
    await(inStep);
    writing.countDown();
    t.setWhichChoice(9);
    assertThat(t.getWhichChoice()).isEqualTo(9);
    step.get(30, TimeUnit.SECONDS);
    assertThat(t.getWhichChoice()).isEqualTo(9);
  }

  @Test
  void aListenerThatWaitsForAThreadThatWritesDoesNotLockUp() throws Exception {
    s.getField("whichChoice")
        .addX3DEventListener(
            event -> {
              try {
                elsewhere(
                    () -> {
                      t.setWhichChoice(3);
                      t.setWhichChoice(4);
                      return null;
                    });
              } catch (Exception e) {
                throw new IllegalStateException(e);
              }
            });
    s.setWhichChoice(1);
    sai.step();
    assertThat(t.getWhichChoice()).isEqualTo(-1);
    sai.step();
    assertThat(t.getWhichChoice()).isEqualTo(4);
    assertThat(sai.complaints()).isEmpty();
  }

  @Test
  void writesOfManyThreadsWhileTheWorldStepsAreNeitherLostNorReordered() throws Exception {
    int writers = 4;
    int writes = 300;
    Switch[] nodes = new Switch[writers];
    List<List<Integer>> heard = new ArrayList<>();
    for (int w = 0; w < writers; w++) {
      nodes[w] = (Switch) sai.make("Switch");
      sai.scene().addRootNode(nodes[w]);
      SFInt32 choice = (SFInt32) nodes[w].getField("whichChoice");
      List<Integer> list = new ArrayList<>();
      heard.add(list);
      choice.addX3DEventListener(event -> list.add(choice.getValue()));
    }
    var key = (MFInt32) sai.make("IntegerSequencer").getField("keyValue");
    var sequencer = sai.make("IntegerSequencer");
    sai.scene().addRootNode(sequencer);
    MFInt32 shared = (MFInt32) sequencer.getField("keyValue");
    assertThat(key.getSize()).isZero();
    List<Future<?>> running = new ArrayList<>();
    for (int w = 0; w < writers; w++) {
      Switch mine = nodes[w];
      int id = w;
      running.add(
          others.submit(
              () -> {
                for (int i = 1; i <= writes; i++) {
                  mine.setWhichChoice(i);
                  assertThat(mine.getWhichChoice()).isEqualTo(i);
                  shared.append(id * writes + i);
                }
                return null;
              }));
    }
    while (running.stream().anyMatch(future -> !future.isDone())) {
      sai.step();
    }
    for (Future<?> future : running) {
      future.get();
    }
    sai.step();
    for (List<Integer> list : heard) {
      assertThat(list).hasSize(writes).isSorted().last().isEqualTo(writes);
    }
    int[] all = new int[shared.getSize()];
    shared.getValue(all);
    assertThat(all).hasSize(writers * writes).doesNotHaveDuplicates();
    for (int w = 0; w < writers; w++) {
      int from = w * writes;
      assertThat(java.util.Arrays.stream(all).filter(v -> v > from && v <= from + writes).toArray())
          .isSorted();
    }
  }

  @Test
  void aNodeThatIsNotRealizedIsWrittenWhateverTheWorldDoes() {
    sai.browser.beginUpdate();
    Switch made = (Switch) sai.make("Switch");
    made.setWhichChoice(3);
    assertThat(made.getWhichChoice()).isEqualTo(3);
    sai.browser.endUpdate();
  }

  private static void await(CountDownLatch latch) {
    try {
      assertThat(latch.await(30, TimeUnit.SECONDS)).isTrue();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
