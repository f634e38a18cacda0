// SPDX-License-Identifier: Apache-2.0

// Distance and contacts of two shapes, and one step of a universe.
package main

import (
	"abut"
	"fmt"
	"log"
)

func run() error {
	ball, err := abut.Sphere(1)
	if err != nil {
		return err
	}
	defer ball.Release()
	box, err := abut.Box(1, 1, 1)
	if err != nil {
		return err
	}
	defer box.Release()
	origin, above := abut.At(0, 0, 0), abut.At(0, 0, 1.75)

	found, err := abut.PairDistance(box, origin, ball, above)
	if err != nil {
		return err
	}
	n := found.Normal
	fmt.Printf("distance %g, normal (%g, %g, %g)\n", found.Distance, n[0], n[1], n[2])
	points, err := abut.PairContacts(box, origin, box, above)
	if err != nil {
		return err
	}
	fmt.Printf("two boxes touch in %d points\n", len(points))

	universe, err := abut.NewUniverse(1)
	if err != nil {
		return err
	}
	defer universe.Destroy()
	for _, body := range []struct {
		shape *abut.Shape
		pose  abut.Pose
	}{{box, origin}, {ball, above}} {
		part, err := universe.AddPart(abut.Dynamic, body.pose)
		if err != nil {
			return err
		}
		if _, err = universe.AddGeometry(part, body.shape); err != nil {
			return err
		}
	}
	if err = universe.Step(0.01); err != nil {
		return err
	}
	contacts, err := universe.Contacts()
	for _, contact := range contacts {
		fmt.Printf("contact %g deep\n", -contact.Distance)
	}
	return err
}

func main() {
	if err := run(); err != nil {
		log.Fatal(err)
	}
}
