export function configureRenderer(renderer) {}
