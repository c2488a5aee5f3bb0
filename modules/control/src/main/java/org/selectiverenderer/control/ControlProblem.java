package org.selectiverenderer.control;

import org.web3d.x3d.sai.X3DNode;

/**
 * A problem or remark about the scene's metadata for its author.
 *
 * @param nodeName the name of the Switch or ProximitySensor
 * @param node the node at fault: often a metadata node of the Switch or sensor
 * @param severity whether something is wrong, or only worth knowing
 * @param message one sentence that says what is wrong and what the controller does about it
 */
public record ControlProblem(String nodeName, X3DNode node, Severity severity, String message) {
  /** The severity of a problem. */
  public enum Severity {
    /** Something is probably not as the author wants it. */
    WARNING,
    /** Often as it should be, yet the author may want to know. */
    INFO
  }

  /** Makes a warning. */
  static ControlProblem warning(String nodeName, X3DNode node, String message) {
    return new ControlProblem(nodeName, node, Severity.WARNING, message);
  }

  /** Formats the problem for messages without a place in the file. */
  @Override
  public String toString() {
    return nodeName + ": " + message;
  }
}
