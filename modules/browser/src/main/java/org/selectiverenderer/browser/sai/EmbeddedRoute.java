package org.selectiverenderer.browser.sai;

import org.selectiverenderer.browser.scene.Route;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DRoute;

/** The SAI's route object. Two are equal when they connect the same fields. */
record EmbeddedRoute(SaiContext binding, Route route) implements X3DRoute {
  @Override
  public X3DNode getSourceNode() {
    return binding.exactly(route.from());
  }

  @Override
  public String getSourceField() {
    return route.from().type().fields().get(route.fromField()).name();
  }

  @Override
  public X3DNode getDestinationNode() {
    return binding.exactly(route.to());
  }

  @Override
  public String getDestinationField() {
    return route.to().type().fields().get(route.toField()).name();
  }
}
