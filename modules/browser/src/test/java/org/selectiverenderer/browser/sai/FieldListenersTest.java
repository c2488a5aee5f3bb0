package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.grouping.Switch;

class FieldListenersTest {
  private final SaiFixture sai = SaiFixture.showing("<Switch DEF='S'/><Switch DEF='T'/>");
  private final Switch s = sai.node("S", Switch.class);
  private final SFInt32 choice = (SFInt32) s.getField("whichChoice");
  private final List<String> heard = new ArrayList<>();

  @AfterEach
  void close() {
    sai.close();
  }

  private X3DFieldEventListener hearing(String name) {
    return event -> heard.add(name + choice.getValue());
  }

  @Test
  void listenersHearInTheNextFrameInTheOrderInWhichTheyCame() {
    choice.addX3DEventListener(hearing("a"));
    choice.addX3DEventListener(hearing("b"));
    choice.addX3DEventListener(hearing("c"));
    s.setWhichChoice(4);
    assertThat(heard).isEmpty();
    sai.step();

    assertThat(heard).containsExactly("a4", "b4", "c4");
    sai.step();
    assertThat(heard).hasSize(3);
  }

  @Test
  void aListenerThatIsAddedTwiceHearsOnceAndIsRemovedOnce() {
    X3DFieldEventListener listener = hearing("a");
    choice.addX3DEventListener(listener);
    s.getField("whichChoice").addX3DEventListener(listener);
    s.setWhichChoice(1);
    sai.step();
    assertThat(heard).containsExactly("a1");

    s.getField("whichChoice").removeX3DEventListener(listener);
    s.setWhichChoice(2);
    sai.step();
    assertThat(heard).hasSize(1);
  }

  @Test
  void aListenerThatIsRemovedMeanwhileIsNotCalledAnyMore() {
    X3DFieldEventListener last = hearing("last");
    choice.addX3DEventListener(
        event -> {
          heard.add("first");
          choice.removeX3DEventListener(last);
        });
    choice.addX3DEventListener(last);
    s.setWhichChoice(1);
    s.setWhichChoice(2);
    sai.step();

    assertThat(heard).containsExactly("first", "first");
  }

  @Test
  void removingWhatIsNotThereDoesNothing() {
    choice.removeX3DEventListener(hearing("a"));
    choice.addX3DEventListener(hearing("b"));
    choice.removeX3DEventListener(hearing("a"));
    s.setWhichChoice(1);
    sai.step();
    assertThat(heard).containsExactly("b1");
  }

  @Test
  void eventsTellFieldTimeAndUserData() {
    List<Object> seen = new ArrayList<>();
    s.getField("whichChoice").setUserData("mine");
    assertThat(choice.getUserData()).isEqualTo("mine");
    choice.addX3DEventListener(
        event -> {
          seen.add(event.getSource().equals(choice));
          seen.add(event.getTime());
          seen.add(event.getData() == null ? "nothing" : event.getData());
        });
    sai.step();
    s.setWhichChoice(1); // between the frames at 1 and 2
    sai.step();
    choice.setUserData(null);
    assertThat(choice.getUserData()).isNull();
    s.setWhichChoice(2);
    sai.step();

    assertThat(seen).containsExactly(true, 2.0, "mine", true, 3.0, "nothing");
  }

  @Test
  void whatAListenerWritesCarriesTheSameTime() {
    List<Double> times = new ArrayList<>();
    Switch t = sai.node("T", Switch.class);
    t.getField("whichChoice").addX3DEventListener(event -> times.add(event.getTime()));
    choice.addX3DEventListener(
        event -> {
          times.add(event.getTime());
          t.setWhichChoice(7);
          assertThat(t.getWhichChoice()).isEqualTo(7);
        });
    s.setWhichChoice(1);
    sai.step();

    assertThat(times).containsExactly(1.0, 1.0);
    assertThat(t.getWhichChoice()).isEqualTo(7);
  }

  @Test
  void listenersOfOutputOnlyFieldsHearAndThoseOfInputOnlyOnesNever() {
    try (SaiFixture area = SaiFixture.showing("<ProximitySensor DEF='P' size='2 2 2'/>")) {
      area.walkTo(5);
      area.node("P")
          .getField("enterTime")
          .addX3DEventListener(event -> heard.add("enter at " + event.getTime()));
      area.walkTo(0);
    }
    assertThat(heard).containsExactly("enter at 2.0");
    try (SaiFixture view = SaiFixture.showing("<Viewpoint DEF='V'/>")) {
      view.node("V").getField("set_bind").addX3DEventListener(event -> heard.add("never"));
      view.node("V", org.web3d.x3d.sai.navigation.Viewpoint.class).setBind(true);
      view.step();
    }
    assertThat(heard).doesNotContain("never");
  }

  @Test
  void aStackThatOverflowsInAListenerIsItsOwnAffair() {
    choice.addX3DEventListener(this::recurse);
    choice.addX3DEventListener(hearing("b"));
    s.setWhichChoice(1);
    sai.step();
    assertThat(heard).containsExactly("b1");
    assertThat(sai.complaints())
        .containsExactly("a listener of whichChoice failed and was skipped: StackOverflowError");
  }

  private void recurse(Object event) {
    recurse(List.of(event));
    heard.add("after recursion");
  }

  @Test
  void whenTheVirtualMachineFailsTheRestIsDeliveredByTheNextFrame() {
    Switch t = sai.node("T", Switch.class);
    choice.addX3DEventListener(
        event -> {
          throw new OutOfMemoryError("as if");
        });
    t.getField("whichChoice").addX3DEventListener(event -> heard.add("t"));
    s.setWhichChoice(1);
    t.setWhichChoice(1);
    assertThatThrownBy(sai::step).isInstanceOf(OutOfMemoryError.class);
    assertThat(heard).isEmpty();

    sai.step();
    assertThat(heard).containsExactly("t");
  }

  @Test
  void afterADisposalListenersOfTheNewObjectAreKnownAndCanBeRemoved() {
    choice.addX3DEventListener(hearing("old"));
    s.dispose();
    Switch again = sai.node("S", Switch.class);
    X3DFieldEventListener listener = event -> heard.add("new");
    again.getField("whichChoice").addX3DEventListener(listener);
    again.getField("whichChoice").addX3DEventListener(listener);
    again.setWhichChoice(3);
    sai.step();
    assertThat(heard).hasSize(1);

    again.getField("whichChoice").removeX3DEventListener(listener);
    again.setWhichChoice(4);
    sai.step();
    assertThat(heard).hasSize(1);
  }

  @Test
  void aNodeThatIsDisposedOfIsSilentAndAnotherObjectTakesItsPlace() {
    choice.addX3DEventListener(hearing("a"));
    s.dispose();
    assertThatThrownBy(s::getWhichChoice)
        .isInstanceOf(org.web3d.x3d.sai.InvalidNodeException.class);
    assertThatThrownBy(choice::getValue).isInstanceOf(org.web3d.x3d.sai.InvalidNodeException.class);
    Switch again = sai.node("S", Switch.class);
    assertThat(again).isNotEqualTo(s);
    again.setWhichChoice(3);
    sai.step();

    assertThat(heard).isEmpty();
    assertThat(sai.complaints()).isEmpty();
    assertThat(again.getWhichChoice()).isEqualTo(3);
  }
}
